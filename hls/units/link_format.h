// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The format of the frames on the serial line between host and board: the one description for the
// units that answer and the host that asks. A frame is
//
//     flag, bytes, CRC of the bytes (lowest byte first), flag
//
// with each flag or escape among bytes and CRC escaped, as in RFC 1662. The bytes of a request are
//
//     command, sequence, length (2), address (4), data of a write
//
// and those of an answer kind, sequence, length (2), data. Numbers have their lowest byte first.
#pragma once

#include <array>

#include "hls/int.h"

namespace dynrt {

inline constexpr unsigned kLinkVersion = 1;       ///< of this format
inline constexpr unsigned kLinkBaud = 3'000'000;  ///< bits a second on the line
inline constexpr unsigned kLineBitsOfByte = 10;   ///< a start, eight of data, a stop

inline constexpr unsigned kLinkFlag = 0x7e;     ///< begins and ends a frame
inline constexpr unsigned kLinkEscape = 0x7d;   ///< before an escaped byte
inline constexpr unsigned kLinkEscaped = 0x20;  ///< by which an escaped byte differs

/// What a request asks for.
enum class LinkCommand : unsigned char {
  kIdentify = 1,        ///< the words of LinkIdentity; at any time, outside the sequence
  kWriteMemory = 2,     ///< `length` bytes from `address` on, both even
  kReadMemory = 3,      ///< the same, both multiples of a beat
  kWriteRegisters = 4,  ///< words of 32 bits, address and length in bytes
  kReadRegisters = 5,   ///< the same
};
/// The kind of an answer.
inline constexpr unsigned kLinkAnswer = 0x80;    ///< and the command that is answered
inline constexpr unsigned kLinkExpected = 0xc0;  ///< a frame is missing; `sequence` is expected
inline constexpr unsigned kLinkRefused = 0xc1;   ///< a frame asks for what the board cannot do

inline constexpr unsigned kLinkHeaderBytes = 8;  ///< of a request
inline constexpr unsigned kLinkAnswerBytes = 4;  ///< of an answer without its data
inline constexpr unsigned kLinkCrcBytes = 4;     ///< of a CRC
inline constexpr unsigned kLinkDataBytes = 512;  ///< most data of a frame
inline constexpr unsigned kLinkReadBeats = 16;   ///< most beats of a memory read
inline constexpr unsigned kLinkReadWords = 16;   ///< most registers that are read at once

inline constexpr unsigned kLinkRingBytes = 2048;  ///< of data that wait in the board
inline constexpr unsigned kLinkWaiting = 16;      ///< most requests that wait in the board
/// Requests that the host may have under way: writes, which never wait for long, and reads, which
/// wait in the board until the answers before them are on the line.
inline constexpr unsigned kLinkWritesUnderWay = 32;  ///< most writes that are not answered yet
inline constexpr unsigned kLinkReadsUnderWay = 16;   ///< most such reads
static_assert(kLinkReadsUnderWay <= kLinkWaiting);

/// Words of the answer to kIdentify. kLinkFacts holds, lowest byte first, the version of this
/// format, the sequence that the board expects next, the bytes of a beat, and the clock of the
/// display's pixels in MHz, which tells its mode, or zero if the board has none.
enum LinkIdentity : unsigned {
  kLinkMagic,        ///< kLinkMagicValue
  kLinkFacts,        ///< four bytes: version, sequence, bytes of a beat, MHz of a pixel
  kLinkClockHz,      ///< of the core
  kLinkMemoryBytes,  ///< behind the link
  kLinkDivisor,      ///< clocks of the link for a bit on the line
  kLinkName,         ///< the name of the configuration, in this word and all behind it
  kLinkIdentityWords = 16,
};
inline constexpr unsigned kLinkMagicValue = 0x4b4e4c44;  ///< the letters DLNK
inline constexpr unsigned kLinkNameBytes = 44;           ///< of the name, ended by zeros
static_assert(kLinkNameBytes == 4 * (kLinkIdentityWords - kLinkName));
using LinkWords = std::array<hls::uint<32>, kLinkIdentityWords>;

/// CRC-32C (Castagnoli). In a frame of kLinkDataBytes it finds each error of up to
/// five bits and each burst of up to 32; the CRC-32 of Ethernet finds each of up to three.
inline constexpr unsigned kCrcPolynomial = 0x82f63b78;  ///< CRC-32C, the lowest bit first
using Crc = hls::uint<32>;

namespace detail {
/// The CRC of a byte with one bit alone.
constexpr unsigned crc_of_bit(unsigned bit) {
  unsigned crc = 1u << bit;
  for (int i = 0; i < 8; ++i) crc = (crc >> 1) ^ ((crc & 1) != 0 ? kCrcPolynomial : 0);
  return crc;
}
template <unsigned Bit>
constexpr Crc crc_term(hls::uint<8> byte) {
  return hls::select(byte.template bit<Bit>(), Crc::from(crc_of_bit(Bit)), Crc(0));
}
constexpr Crc crc_of_byte(hls::uint<8> b) {
  return ((crc_term<0>(b) ^ crc_term<1>(b)) ^ (crc_term<2>(b) ^ crc_term<3>(b))) ^
         ((crc_term<4>(b) ^ crc_term<5>(b)) ^ (crc_term<6>(b) ^ crc_term<7>(b)));
}
}  // namespace detail

inline constexpr Crc kCrcStart = Crc::ones();

/// Takes a byte into a CRC. The byte's part is apart, so that a pipeline can add it up beforehand.
constexpr Crc crc_step(Crc crc, hls::uint<8> byte) {
  return detail::crc_of_byte(crc.trunc<8>()) ^ (crc.shr<8>() ^ detail::crc_of_byte(byte));
}

namespace detail {
constexpr Crc crc_residue() {
  const Crc sent = ~kCrcStart;
  Crc crc = kCrcStart;
  for (unsigned i = 0; i < kLinkCrcBytes; ++i) {
    crc = crc_step(crc, hls::uint<8>::from(sent.raw() >> (8 * i)));
  }
  return crc;
}
}  // namespace detail
/// The CRC of bytes with their own complemented CRC behind them.
inline constexpr Crc kCrcResidue = detail::crc_residue();

}  // namespace dynrt
