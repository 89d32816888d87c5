// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The files of the page. The server gives no other file. The program reads them once, so no name in
// a request ever reaches the disk.
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
