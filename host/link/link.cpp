// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/link/link.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <utility>

#include "host/error.h"

namespace dynrt::host {

namespace {

constexpr char kNonsense[] =
    "board {}: it sent {} bytes, but no answer of dynrt; load a bitstream of dynrt into the board, "
    "or name its device";

constexpr unsigned kIdentifications = 5;  ///< that are sent before it gives up
/// Bytes that are handed to the line before it has sent them; with fewer it goes back sooner.
constexpr std::size_t kAhead = 2 * kLinkDataBytes;

std::uint32_t word_at(std::span<const std::uint8_t> bytes, std::size_t word) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value |= std::uint32_t{bytes[4 * word + i]} << (8 * i);
  return value;
}
std::uint8_t answer_to(LinkCommand command) {
  return static_cast<std::uint8_t>(kLinkAnswer | static_cast<unsigned>(command));
}
std::array<std::uint8_t, 4> little_endian(std::uint32_t word) {
  std::array<std::uint8_t, 4> bytes;
  for (unsigned i = 0; i < 4; ++i) bytes[i] = static_cast<std::uint8_t>(word >> (8 * i));
  return bytes;
}
bool is_write(LinkCommand command) {
  return command == LinkCommand::kWriteMemory || command == LinkCommand::kWriteRegisters;
}

}  // namespace

BoardLink::BoardLink(std::unique_ptr<ByteStream> line, LinkPatience patience)
    : line_(std::move(line)), patience_(patience) {
  identify();
}

void BoardLink::identify() {
  std::optional<LinkAnswerFrame> found;
  for (unsigned i = 0; i < kIdentifications && !found; ++i) {
    std::vector<std::uint8_t> out;
    append_frame(out,
                 {.command = LinkCommand::kIdentify, .sequence = static_cast<std::uint8_t>(i)});
    const ByteStream::Time deadline = line_->now() + patience_.quiet;
    while (line_->now() < deadline && !found) {
      send(out);
      for (LinkAnswerFrame& answer : receive(!out.empty(), deadline)) {
        if (answer.kind != answer_to(LinkCommand::kIdentify) || answer.sequence != i) continue;
        if (answer.data.size() == 4 * kLinkIdentityWords) found = std::move(answer);
      }
    }
  }
  if (!found && reader_.bytes() == 0) {
    refuse("board {}: nothing answers; switch the board on, and load a bitstream of dynrt into it",
           name());
  }
  if (!found || word_at(found->data, kLinkMagic) != kLinkMagicValue) {
    refuse(kNonsense, name(), reader_.bytes());
  }
  const std::uint32_t facts = word_at(found->data, kLinkFacts);
  board_.version = facts & 0xff;
  sequence_ = static_cast<std::uint8_t>(facts >> 8);
  board_.beat_bytes = facts >> 16 & 0xff;
  board_.pixel_mhz = facts >> 24;
  board_.clock_hz = word_at(found->data, kLinkClockHz);
  board_.memory_bytes = word_at(found->data, kLinkMemoryBytes);
  board_.divisor = word_at(found->data, kLinkDivisor);
  const std::span letters = std::span(found->data).subspan(4 * kLinkName);
  board_.configuration.assign(letters.begin(), std::ranges::find(letters, 0));
  if (board_.version != kLinkVersion) {
    refuse(
        "board {}: its link has version {}, but this program speaks version {}; load a bitstream "
        "of this version of dynrt",
        name(), board_.version, kLinkVersion);
  }
  if (board_.beat_bytes < 2) refuse(kNonsense, name(), reader_.bytes());
}

void BoardLink::expect_configuration(std::string_view configuration) const {
  if (board_.configuration == configuration) return;
  refuse(
      "board {}: its bitstream has configuration {}, but configuration {} is asked for; load a "
      "bitstream of that one, or ask for configuration {}",
      name(), board_.configuration, configuration, board_.configuration);
}

void BoardLink::send(std::vector<std::uint8_t>& bytes) {
  if (bytes.empty()) return;
  const std::size_t sent = line_->write(bytes);
  counts_.sent += sent;
  bytes.erase(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(sent));
}

std::vector<LinkAnswerFrame> BoardLink::receive(bool to_write, ByteStream::Time deadline) {
  line_->wait(to_write, deadline);
  std::array<std::uint8_t, 4096> bytes;
  const std::size_t received = line_->read(bytes);
  counts_.received += received;
  std::vector<LinkAnswerFrame> answers;
  for (std::size_t i = 0; i < received; ++i) {
    if (auto answer = reader_.take(bytes[i])) answers.push_back(std::move(*answer));
  }
  counts_.bad_answers = reader_.bad_frames();
  return answers;
}

void BoardLink::exchange(Requests& requests) {
  const LinkCounts at_first = counts_;
  LinkWindow window(requests.frames.size(), requests.most_under_way, requests.writes);
  std::vector<std::uint8_t> out;
  ByteStream::Time deadline = line_->now() + patience_.quiet;
  unsigned in_a_row = 0;
  std::uint64_t carried = 0;
  while (!window.done()) {
    while (out.size() < kAhead) {
      const std::optional<std::size_t> next = window.next();
      if (!next) break;
      LinkRequestFrame frame = requests.frames[*next];
      frame.sequence = static_cast<std::uint8_t>(sequence_ + *next);
      append_frame(out, frame);
    }
    send(out);
    const std::size_t before = window.answered();
    for (const LinkAnswerFrame& answer : receive(!out.empty(), deadline)) {
      take(requests, window, answer);
    }
    for (std::size_t i = before; i < window.answered(); ++i) carried += requests.frames[i].length;
    if (requests.progress && window.answered() > before) requests.progress(carried);
    if (window.answered() > before) {
      in_a_row = 0;
      deadline = line_->now() + patience_.quiet;
    } else if (line_->now() >= deadline) {
      if (in_a_row++ == patience_.repeats) give_up(window.answered(), requests.frames.size());
      ++counts_.timeouts;
      window.repeat_all();
      deadline = line_->now() + patience_.quiet;
    }
  }
  counts_.requests += requests.frames.size();
  counts_.repeats += window.repeats();
  counts_.carried += carried;
  counts_.busy += std::max(counts_.sent - at_first.sent, counts_.received - at_first.received);
  sequence_ = static_cast<std::uint8_t>(sequence_ + requests.frames.size());
}

void BoardLink::take(Requests& requests, LinkWindow& window, const LinkAnswerFrame& answer) {
  const auto number = static_cast<std::uint8_t>(answer.sequence - sequence_);
  if (answer.kind == kLinkExpected) {
    ++counts_.missed;
    window.missing(number);
  }
  const std::optional<std::size_t> request = window.under_way(number);
  if (request) {
    const LinkRequestFrame& frame = requests.frames[*request];
    if (answer.kind == kLinkRefused) {
      refuse(
          "board {}: it refuses to {} {} bytes at address {:#x}; load a bitstream of this version "
          "of dynrt",
          name(), is_write(frame.command) ? "write" : "read", frame.length, frame.address);
    }
    const std::size_t length = is_write(frame.command) ? 0 : frame.length;
    if (answer.kind == answer_to(frame.command) && answer.data.size() == length) {
      if (requests.take) requests.take(*request, answer.data);
      window.answer(*request);
    }
  }
}

void BoardLink::give_up(std::size_t answered, std::size_t requests) const {
  if (reader_.in_frame()) {
    refuse(
        "board {}: it stopped in the middle of an answer, after {} of {} requests, although each "
        "was repeated {} times; reset the board and start again",
        name(), answered, requests, patience_.repeats);
  }
  refuse(
      "board {}: it stopped answering after {} of {} requests, although each was repeated {} "
      "times; reset the board and start again",
      name(), answered, requests, patience_.repeats);
}

void BoardLink::check_range(std::uint32_t address, std::size_t bytes) const {
  const std::uint64_t end = std::uint64_t{address} + bytes;
  if (end <= board_.memory_bytes) return;
  refuse(
      "board {}: {} bytes at address {:#x} do not fit into its memory of {} bytes, by {} bytes; "
      "take a smaller scene",
      name(), bytes, address, board_.memory_bytes, end - board_.memory_bytes);
}

void BoardLink::write_memory(std::span<const MemoryBytes> parts, const LinkProgress& progress) {
  for (const MemoryBytes& part : parts) check_range(part.address, part.bytes.size());
  Requests requests{.frames = write_frames(parts),
                    .most_under_way = kLinkWritesUnderWay,
                    .writes = true,
                    .progress = progress};
  exchange(requests);
}

void BoardLink::write_memory(std::uint32_t address, std::span<const std::uint8_t> bytes) {
  const MemoryBytes part{address, {bytes.begin(), bytes.end()}};
  write_memory({&part, 1});
}

void BoardLink::read_memory(std::uint32_t address, std::span<std::uint8_t> bytes,
                            const LinkProgress& progress) {
  check_range(address, bytes.size());
  const std::uint32_t beat = board_.beat_bytes;
  const std::uint32_t most = std::min(kLinkDataBytes, kLinkReadBeats * beat);
  const std::uint32_t end =
      (address + static_cast<std::uint32_t>(bytes.size()) + beat - 1) / beat * beat;
  Requests requests{.most_under_way = kLinkReadsUnderWay, .progress = progress};
  for (std::uint32_t at = address / beat * beat; at < end;) {
    const std::uint32_t length = std::min(most - at % most, end - at);
    requests.frames.push_back({.command = LinkCommand::kReadMemory,
                               .length = static_cast<std::uint16_t>(length),
                               .address = at});
    at += length;
  }
  requests.take = [&](std::size_t request, std::span<const std::uint8_t> data) {
    const std::uint32_t at = requests.frames[request].address;
    for (std::uint32_t i = 0; i < data.size(); ++i) {
      if (at + i >= address && at + i - address < bytes.size()) bytes[at + i - address] = data[i];
    }
  };
  exchange(requests);
}

void BoardLink::write_registers(std::uint32_t address, std::span<const std::uint32_t> words) {
  std::vector<std::uint8_t> bytes;
  for (const std::uint32_t word : words)
    std::ranges::copy(little_endian(word), std::back_inserter(bytes));
  Requests requests{.most_under_way = kLinkWritesUnderWay, .writes = true};
  for (std::size_t at = 0; at < bytes.size(); at += kLinkDataBytes) {
    const std::size_t length = std::min<std::size_t>(kLinkDataBytes, bytes.size() - at);
    requests.frames.push_back({.command = LinkCommand::kWriteRegisters,
                               .length = static_cast<std::uint16_t>(length),
                               .address = static_cast<std::uint32_t>(address + at),
                               .data = std::span(bytes).subspan(at, length)});
  }
  exchange(requests);
}

void BoardLink::read_registers(std::uint32_t address, std::span<std::uint32_t> words) {
  Requests requests{.most_under_way = kLinkReadsUnderWay};
  for (std::size_t at = 0; at < words.size(); at += kLinkReadWords) {
    const std::size_t length = std::min<std::size_t>(kLinkReadWords, words.size() - at);
    requests.frames.push_back({.command = LinkCommand::kReadRegisters,
                               .length = static_cast<std::uint16_t>(4 * length),
                               .address = static_cast<std::uint32_t>(address + 4 * at)});
  }
  requests.take = [&](std::size_t request, std::span<const std::uint8_t> data) {
    for (std::size_t i = 0; i < data.size() / 4; ++i) {
      words[request * kLinkReadWords + i] = word_at(data, i);
    }
  };
  exchange(requests);
}

std::uint32_t BoardLink::write_then_read(std::uint32_t to, std::uint32_t value,
                                         std::uint32_t from) {
  const std::array<std::uint8_t, 4> bytes = little_endian(value);
  std::uint32_t word = 0;
  // If the read is repeated, the board has carried out the write before it.
  Requests requests{
      .frames = {{.command = LinkCommand::kWriteRegisters,
                  .length = bytes.size(),
                  .address = to,
                  .data = bytes},
                 {.command = LinkCommand::kReadRegisters, .length = bytes.size(), .address = from}},
      .most_under_way = 2,
      .take = [&](std::size_t request, std::span<const std::uint8_t> data) {
        if (request == 1) word = word_at(data, 0);
      }};
  exchange(requests);
  return word;
}

}  // namespace dynrt::host
