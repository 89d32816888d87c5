// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The files of the page. Only these can be read through the server; they are read once, so that no
// name in a request ever reaches the disk.
#pragma once

#include <map>
#include <string>

namespace dynrt::host {

struct PageFile {
  std::string type;  ///< of its content, as HTTP names it
  std::string text;
};

/// By the path in the address, such as /main.js; "/" is the page. Throws UserError if one is
/// missing.
std::map<std::string, PageFile> page_files();

}  // namespace dynrt::host
