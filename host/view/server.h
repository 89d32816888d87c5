// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The web server of the window, on the loopback address. It gives the page's files, and answers the
// questions of pages that it has served itself.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "host/view/message.h"
#include "host/view/page_files.h"

namespace dynrt::host {

class ViewServer {
 public:
  /// `answer` throws as Session::answer does; several threads may call it at once. Throws UserError
  /// if no port is free.
  ViewServer(std::map<std::string, PageFile> files, unsigned port,
             std::function<Answer(const Json&)> answer);
  ~ViewServer();
  ViewServer(const ViewServer&) = delete;
  ViewServer& operator=(const ViewServer&) = delete;

  /// The one that was asked for, or the next that is free.
  unsigned port() const;
  std::string address() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace dynrt::host
