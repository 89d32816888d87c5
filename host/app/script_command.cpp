// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/script_command.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <vector>

#include "host/board/load_configuration.h"
#include "host/error.h"

namespace dynrt::host {

ScriptCommand add_script_command(CLI::App& parent, const std::string& name,
                                 const std::string& about, const std::string& script,
                                 const std::string& first) {
  CLI::App* app = parent.add_subcommand(name, about);
  app->set_help_flag();
  app->prefix_command();
  return {app, [app, script, first]() -> int {
            const ThisBuild build = this_build();
            const std::string path = std::string(build.scripts) + "/" + script;
            const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
            std::vector<std::string> words = {path,
                                              "--program",
                                              program,
                                              "--build",
                                              std::string(build.description),
                                              "--expect",
                                              std::string(build.fingerprint)};
            if (!first.empty()) words.insert(words.begin() + 1, first);
            for (const std::string& word : app->remaining()) words.push_back(word);
            std::vector<char*> arguments;
            for (std::string& word : words) arguments.push_back(word.data());
            arguments.push_back(nullptr);
            execv(path.c_str(), arguments.data());
            refuse(
                "{}: cannot run this script: {}; the program needs the source folder that it was "
                "built from",
                path, std::string(std::strerror(errno)));
          }};
}

}  // namespace dynrt::host
