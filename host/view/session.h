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

#include "host/view/full_picture.h"
#include "host/view/job_runner.h"
#include "host/view/message.h"
#include "host/view/page_files.h"

namespace dynrt::host {

class Session {
 public:
  /// Watching a frame ends early while `urgent` is not 0, as somebody waits for another frame.
  Session(ViewServices services, const std::atomic<unsigned>& urgent)
      : services_(std::move(services)), urgent_(urgent) {}

  /// Throws NotOurs for a question that the page does not ask, and UserError with a sentence for
  /// the reader; then all is as before.
  Answer answer(const Json& question);

  /// The page as one file, with the frame that the scene's camera sees.
  std::string record(const std::map<std::string, PageFile>& files);

  /// A job that renders the full picture through the RTL and compares the two; it may run in
  /// another thread. Throws UserError if there is no full picture.
  JobRunner::Job comparison(const Json& question);

 private:
  /// The opened scene and its boards. Each of two boards draws half of a coarse picture, so that
  /// two processors work; the first one draws the full picture.
  struct Setup {
    ViewChoices choices;
    std::array<Renderer, 2> renderers;
    std::unique_ptr<Renderer> clocked;  ///< made when the first frame is watched
    std::string schedules;              ///< the folder of the schedules of `clocked`, or empty
    LoadedScene loaded;
    std::shared_ptr<const ViewTruth> truth;  ///< of the scene at `truth_time`
    std::optional<double> truth_time;
    std::optional<FullPicture> picture;
  };

  Answer open(const ViewChoices& choices);
  Answer frame(const PictureRequest& request);
  /// Renders the full picture again and watches the units: {"stopped": true}, or machine_json.
  Answer examine(const Json& question);
  Answer pixel(const Json& question);
  Answer map(const Json& question);
  /// The place of the scene's own camera at a "time".
  Answer on_path(const Json& question);
  /// All hit records as lines of text.
  Answer csv(const Json& question);
  Setup& setup();
  /// The full picture that a question is about. Throws UserError if there is a newer one.
  FullPicture& picture(const Json& question);
  FullPicture& picture();
  /// Renders with clocks, if the schedules are there by now.
  Renderer& clocked(FullPicture& now);
  Json watch(FullPicture& now, Renderer& renderer);
  void find_truth();
  FrameOptions options_of(const PictureRequest& request) const;
  Frame whole(const PictureRequest& request);
  void keep_picture(const PictureRequest& request, const Frame& frame);
  /// Renders the upper and the lower part at the same time. Each part has a camera of its own,
  /// whose numbers may differ in the last place from those of the full picture's camera.
  Frame in_two_parts(const PictureRequest& request);

  ViewServices services_;
  const std::atomic<unsigned>& urgent_;
  std::unique_ptr<Setup> setup_;
  unsigned pictures_ = 0;  ///< full pictures so far
  unsigned opened_ = 0;    ///< scenes opened so far, one for each change of the choices
  double upper_ = 0.5;     ///< share of the picture's rows that the first board draws
};

}  // namespace dynrt::host
