// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A configuration as a shared library, for load_configuration_test, which puts the fingerprint that
// it wants in place of the one below. Its core does nothing.
#include "host/board/loadable.h"

namespace dynrt::host {

namespace {

class IdleCore final : public NativeCore {
 public:
  void write(unsigned, std::uint32_t, std::span<const std::uint32_t>) override {}
  void read(unsigned, std::uint32_t, std::span<std::uint32_t>) override {}
  std::optional<std::uint64_t> render(const FrameConfig&, const hls::ModuleSchedules*,
                                      FrameWatch*) override {
    return std::nullopt;
  }
  std::vector<Counter> counters() override { return {}; }
};

CoreInfo info() {
  CoreInfo info;
  info.packets = 3;
  info.made_for = "sail";
  info.made_from = "whitted";
  return info;
}

}  // namespace

}  // namespace dynrt::host

extern "C" {

const char dynrt_configuration_fingerprint[] = "00000000000000000000000000000000";

const dynrt::host::Configuration* dynrt_configuration() {
  static constexpr dynrt::host::Configuration kConfiguration = {
      .name = "loadable",
      .core = dynrt::host::info,
      .native = []() -> std::unique_ptr<dynrt::host::NativeCore> {
        return std::make_unique<dynrt::host::IdleCore>();
      }};
  return &kConfiguration;
}
}
