// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The messages of the link to a board.
#pragma once

namespace dynrt::host::messages {

inline constexpr char kNoDevice[] =
    "board serial:{}: there is no such device; connect the board, or name the device that it is";
inline constexpr char kDeviceBusy[] =
    "board serial:{}: another program uses the device; end that program first";
inline constexpr char kDeviceForbidden[] =
    "board serial:{}: you may not open the device; join the group that owns it, often dialout";
inline constexpr char kNotSerial[] =
    "board serial:{}: this is no serial device; name one, such as /dev/ttyUSB0";
inline constexpr char kDeviceFails[] = "board serial:{}: the device fails: {}";
inline constexpr char kNoSpeed[] =
    "board serial:{}: the device has no speed of {} bits a second; take an adapter that has";
inline constexpr char kDeviceGone[] =
    "board {}: the line is no more; leave the board connected and switched on";
inline constexpr char kSilent[] =
    "board {}: nothing answers; switch the board on, and load a bitstream of dynrt into it";
inline constexpr char kNonsense[] =
    "board {}: {} bytes came, but no answer of dynrt among them; load a bitstream of dynrt into "
    "the "
    "board, or name the device that it is";
inline constexpr char kStops[] =
    "board {}: it answers no more after {} of {} requests, although each was repeated {} times; "
    "reset the board and start again";
inline constexpr char kStopsInFrame[] =
    "board {}: it stops in the middle of an answer, after {} of {} requests, although each was "
    "repeated {} times; reset the board and start again";
inline constexpr char kOtherLink[] =
    "board {}: its link has version {}, but this program speaks version {}; load a bitstream of "
    "this version of dynrt";
inline constexpr char kOtherConfiguration[] =
    "board {}: its bitstream has configuration {}, but configuration {} is asked for; load a "
    "bitstream of that one, or ask for configuration {}";
inline constexpr char kLinkRefuses[] =
    "board {}: it refuses to {} {} bytes at address {:#x}; load a bitstream of this version of "
    "dynrt";
inline constexpr char kMemoryTooSmall[] =
    "board {}: {} bytes at address {:#x} do not fit into its memory of {} bytes, by {} bytes; take "
    "a "
    "smaller scene";

}  // namespace dynrt::host::messages
