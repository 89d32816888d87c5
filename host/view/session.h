// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The core behind the window: answers what the page asks. All calls come from one thread.
#pragma once

#include <array>
#include <atomic>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "host/view/message.h"
#include "host/view/page_files.h"
#include "host/view/still.h"
#include "host/view/workshop.h"

namespace dynrt::host {

class Session {
 public:
  /// A frame that is watched ends early while `urgent` is not 0: somebody waits for another one.
  Session(ViewStudio studio, const std::atomic<unsigned>& urgent)
      : studio_(std::move(studio)), urgent_(urgent) {}

  /// Throws NotOurs for a question that the page does not ask, and UserError with a sentence for
  /// the reader; then all is as before.
  Answer answer(const Json& question);

  /// The page as one file, with the frame that the scene's camera sees.
  std::string record(const std::map<std::string, PageFile>& files);

  /// Renders the frame that stands through the RTL and compares the two; the job may run in
  /// another thread. Throws UserError if no frame stands.
  Workshop::Job comparison(const Json& question);

 private:
  /// Two boards, so that both processors draw while one walks; the first draws alone what stands.
  struct Room {
    ViewChoices choices;
    std::array<Easel, 2> easels;
    std::unique_ptr<Easel> clocked;  ///< made when the first frame is watched
    std::string schedules;           ///< the folder of those that it was made with, or empty
    Scenery scenery;
    std::shared_ptr<const ViewTruth> truth;  ///< of the moment that the scenery stands at
    std::optional<double> truth_time;
    std::optional<Still> still;
  };

  Answer open(const ViewChoices& choices);
  Answer frame(const Shot& shot);
  /// Renders what stands again and watches: {"stopped": true}, or the machine.
  Answer examine(const Json& question);
  Answer pixel(const Json& question);
  Answer map(const Json& question);
  /// Where the scene's own camera stands at a "time".
  Answer on_path(const Json& question);
  /// All hit records as lines of text.
  Answer csv(const Json& question);
  Room& room();
  /// The frame that a question is about. Throws UserError if it no longer stands.
  Still& still(const Json& question);
  Still& still();
  /// Draws clock by clock, if the schedules are there by now.
  Easel& clocked(Still& now);
  Json watch(Still& now, Easel& easel);
  void find_truth();
  FrameOptions options_of(const Shot& shot) const;
  Frame whole(const Shot& shot);
  void keep_still(const Shot& shot, const Frame& frame);
  /// Upper and lower part side by side. Their rays are those of two cameras, whose numbers may
  /// differ in the last place from those of the whole picture's.
  Frame in_two_parts(const Shot& shot);

  ViewStudio studio_;
  const std::atomic<unsigned>& urgent_;
  std::unique_ptr<Room> room_;
  unsigned frames_ = 0;  ///< that stood
  unsigned opened_ = 0;  ///< times that other choices were taken
  double upper_ = 0.5;   ///< share of the picture's rows that the first board draws
};

}  // namespace dynrt::host
