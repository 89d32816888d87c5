// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The core behind the window: answers what the page asks. All calls come from one thread.
#pragma once

#include <array>
#include <memory>

#include "host/view/message.h"

namespace dynrt::host {

class Session {
 public:
  explicit Session(ViewStudio studio) : studio_(std::move(studio)) {}

  /// Throws NotOurs for a question that the page does not ask, and UserError with a sentence for
  /// the reader; then all is as before.
  Answer answer(const Json& question);

 private:
  /// Two boards, so that both processors draw while one walks; the first draws alone what stands.
  struct Room {
    ViewChoices choices;
    std::array<Easel, 2> easels;
    Scenery scenery;
  };

  Answer open(const ViewChoices& choices);
  Answer frame(const Shot& shot);
  Room& room();
  FrameOptions options_of(const Shot& shot) const;
  Frame whole(const Shot& shot);
  /// Upper and lower part side by side. Their rays are those of two cameras, whose numbers may
  /// differ in the last place from those of the whole picture's.
  Frame in_two_parts(const Shot& shot);

  ViewStudio studio_;
  std::unique_ptr<Room> room_;
  double upper_ = 0.5;  ///< share of the picture's rows that the first board draws
};

}  // namespace dynrt::host
