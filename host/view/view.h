// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The live window on the core: a server, a session behind it and a browser before it, until the
// user stops the program.
#pragma once

#include <functional>
#include <string>

#include "host/view/studio.h"

namespace dynrt::host {

inline constexpr unsigned kViewPort = 7710;

struct ViewWindow {
  unsigned port = kViewPort;  ///< or the next that is free
  bool browser = true;        ///< open one
  std::function<void(const std::string&)> say;
};

/// The window as one file that opens from disk, with the frame that the scene's camera sees. Throws
/// UserError for a picture that is too large.
std::string recorded_view(ViewStudio studio);

/// Returns after an interrupt or a request to terminate; a frame may still be rendered then, so the
/// program must end without waiting for its threads.
void view(ViewStudio studio, const ViewWindow& window);

}  // namespace dynrt::host
