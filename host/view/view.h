// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The live window on the core: starts the server and its session, opens a browser, and runs until
// the user stops the program.
#pragma once

#include <functional>
#include <string>

#include "host/view/view_services.h"

namespace dynrt::host {

inline constexpr unsigned kViewPort = 7710;

struct ViewWindow {
  unsigned port = kViewPort;  ///< or the next that is free
  bool browser = true;        ///< open one
  std::function<void(const std::string&)> say;
};

/// The window as one file that opens from disk, with the frame that the scene's camera sees. Throws
/// UserError for a picture that is too large.
std::string recorded_view(ViewServices services);

/// Returns after an interrupt or a request to terminate; a frame may still be rendered then, so the
/// program must end without waiting for its threads.
void view(ViewServices services, const ViewWindow& window);

}  // namespace dynrt::host
