# One interface target carries the warning flags of everything that is written here.
option(DYNRT_WERROR "treat warnings as errors" OFF)
add_library(dynrt_warnings INTERFACE)
target_compile_options(dynrt_warnings INTERFACE -Wall -Wextra -Wshadow -Wconversion
                       -Wno-sign-conversion -Wno-bit-int-extension $<$<BOOL:${DYNRT_WERROR}>:-Werror>)
