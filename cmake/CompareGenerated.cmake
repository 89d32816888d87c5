# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
# cmake -DNEW=.. -DOLD=.. -P CompareGenerated.cmake: fails when the checked-in file OLD is not NEW.
if(NOT EXISTS ${OLD})
  message(FATAL_ERROR "${OLD} is missing; `ninja update-generated` writes it")
endif()
execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${NEW} ${OLD} RESULT_VARIABLE differs)
if(differs)
  message(FATAL_ERROR "${OLD} is stale; `ninja update-generated` renews it from ${NEW}")
endif()
