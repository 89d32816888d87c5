// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The messages of the front end. Each names the mistake and its remedy; fmt fills in the {}, and
// the tests in test/errors assert the texts.
#pragma once

namespace hlsc::messages {

inline constexpr char kClangMissing[] =
    "{} is not installed or not on the PATH; install the package clang-19 or name it with --clang";
inline constexpr char kHeaderMissing[] =
    "no folder given with -I holds the header {}; add the folder that holds it";
inline constexpr char kNotPrecompiled[] =
    "there is no file {} for --precompiled; hlsc --precompile {} --header hls/language.h writes it";
inline constexpr char kUnitMissing[] =
    "the type {} cannot be used as a unit; give --unit the full name of a complete type that {} "
    "defines. clang says: {}";
inline constexpr char kNoStep[] =
    "the unit {} has no member function void step(); a unit's step() is one transaction";
inline constexpr char kClangFailed[] = "clang rejects the unit:{}";
inline constexpr char kTemporary[] = "the temporary file {} cannot be written: {}";

inline constexpr char kNotAPort[] =
    "member {} has type {}, which is neither a port, an integer, an enum, a bool nor a struct or "
    "array of these; hlsc cannot make it a register";
inline constexpr char kBitField[] =
    "member {} is a bit-field, which hlsc cannot make a register; give it the type hls::uint<{}>";
inline constexpr char kVirtual[] =
    "the unit has virtual functions, but a unit is a plain class; use templates instead";

inline constexpr char kRecursion[] =
    "{} calls itself; write it as a loop with a constant bound or as a template that ends";
inline constexpr char kAssembly[] = "inline assembly cannot be lowered; write it in C++";
inline constexpr char kVolatile[] =
    "volatile accesses cannot be lowered; make the variable a plain local or a member";
inline constexpr char kAtomic[] =
    "atomic operations cannot be lowered; use a plain member, as a transaction is atomic by itself";
inline constexpr char kExceptions[] =
    "exceptions cannot be lowered; return a flag or write a token instead";
inline constexpr char kUnbounded[] =
    "this loop has no bound that is known at compile time; give it a constant number of iterations "
    "(at most {}) and leave it with break";
inline constexpr char kIndirectCall[] =
    "this call goes through a pointer or a virtual function; call the function by its name or make "
    "it a template parameter";
inline constexpr char kExternalCall[] =
    "the unit calls {}, but hlsc cannot see its body; define it in a header or do not call it";
inline constexpr char kAllocation[] =
    "memory is allocated dynamically; use a local array or a RAM member";
inline constexpr char kFloat[] =
    "{} arithmetic cannot be lowered; use hls::Float<E, M> or integers";
inline constexpr char kGlobal[] =
    "the global variable {} is not constant; make it constexpr or a member of the unit";
inline constexpr char kPointer[] =
    "this access goes through a pointer that hlsc cannot follow to one local variable or member; "
    "use an array and an index";
inline constexpr char kPortPointer[] =
    "this access goes to a port that is not known at compile time; name the port, or index its "
    "array with a constant or with the counter of a loop with a constant bound";
inline constexpr char kInTwice[] =
    "In {} is read twice in one transaction; read it once into a local variable";
inline constexpr char kInConditional[] =
    "In {} is read under a condition; a transaction reads one token from every In: read it first "
    "and use the token under the condition";
inline constexpr char kInNever[] =
    "In {} is never read; a transaction reads one token from every In: read it or remove the "
    "member";
inline constexpr char kOutTwice[] =
    "Out {} can be written twice in one transaction; make the writes exclude each other or add a "
    "second Out";
inline constexpr char kRowReadTwice[] =
    "RAM {} can be read twice in one transaction; read the row once, or split the RAM";
inline constexpr char kRowWrittenTwice[] =
    "RAM {} can be written twice in one transaction; put the row together and write it once";
inline constexpr char kReadAfterWrite[] =
    "RAM {} can be read after it was written in the same transaction; read the row before the "
    "write and keep it in a local variable";
inline constexpr char kUninitialised[] =
    "this condition depends on a variable that was never set; give it an initial value";
inline constexpr char kNoEffect[] =
    "the unit writes no token and no row and changes no register; write an Out, or build the unit "
    "with -fsanitize=undefined to look for undefined behaviour";
inline constexpr char kLanguageMissing[] =
    "no folder given with -I holds hls/ports.h for lowering; put the folder hls/lowered of the "
    "language first";
inline constexpr char kOperation[] = "the operation {} cannot be lowered; rewrite this expression";

}  // namespace hlsc::messages
