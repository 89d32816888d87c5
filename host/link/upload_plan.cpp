// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/link/upload_plan.h"

#include <algorithm>
#include <vector>

#include "host/link/link_frame.h"

namespace dynrt::host {

namespace {

double seconds_on_line(std::uint64_t bytes, unsigned baud) {
  return static_cast<double>(bytes * kLineBitsOfByte) / baud;
}

}  // namespace

LineCost upload_cost(std::span<const MemoryBytes> parts, unsigned baud) {
  LineCost cost;
  for (const LinkRequestFrame& frame : write_frames(parts)) {
    std::vector<std::uint8_t> line;
    append_frame(line, frame);
    ++cost.frames;
    cost.carried += frame.length;
    cost.sent += line.size();
  }
  cost.seconds = seconds_on_line(cost.sent, baud);
  return cost;
}

LineCost read_cost(std::uint64_t bytes, unsigned beat_bytes, unsigned baud) {
  const std::uint64_t of_frame = std::min(kLinkDataBytes, kLinkReadBeats * beat_bytes);
  const std::uint64_t frames = (bytes + of_frame - 1) / of_frame;
  const std::uint64_t sent = bytes + frames * kAnswerOverhead;
  return {frames, bytes, sent, seconds_on_line(sent, baud)};
}

bool UploadPlan::note(std::uint32_t address, std::uint8_t low, std::uint8_t high) {
  Page& page = pages_[address / kPageBytes];
  const std::uint32_t at = address % kPageBytes;
  const bool same = page.known[at / 2] && page.bytes[at] == low && page.bytes[at + 1] == high;
  page.bytes[at] = low;
  page.bytes[at + 1] = high;
  page.known[at / 2] = true;
  return !same;
}

bool UploadPlan::append_known(std::vector<std::uint8_t>& to, std::uint32_t begin,
                              std::uint32_t end) const {
  const std::size_t before = to.size();
  for (std::uint32_t address = begin; address < end; address += 2) {
    const auto page = pages_.find(address / kPageBytes);
    const std::uint32_t at = address % kPageBytes;
    if (page == pages_.end() || !page->second.known[at / 2]) {
      to.resize(before);
      return false;
    }
    to.push_back(page->second.bytes[at]);
    to.push_back(page->second.bytes[at + 1]);
  }
  return true;
}

std::vector<MemoryBytes> UploadPlan::changes(std::span<const MemoryBytes> image) {
  std::vector<std::uint32_t> changed;  // addresses of halves
  for (const MemoryBytes& part : image) {
    for (std::uint32_t i = 0; i + 1 < part.bytes.size(); i += 2) {
      const std::uint32_t address = part.address + i;
      if (note(address, part.bytes[i], part.bytes[i + 1])) changed.push_back(address);
    }
  }
  std::ranges::sort(changed);
  std::vector<MemoryBytes> parts;
  std::uint32_t end = 0;  // of the last part
  for (const std::uint32_t address : changed) {
    if (parts.empty() || address - end > kFrameOverhead ||
        !append_known(parts.back().bytes, end, address)) {
      parts.push_back({address, {}});
    }
    append_known(parts.back().bytes, address, address + 2);
    end = address + 2;
  }
  return parts;
}

}  // namespace dynrt::host
