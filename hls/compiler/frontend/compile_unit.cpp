// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "frontend/compile_unit.h"

#include <fmt/format.h>
#include <llvm/IRReader/IRReader.h>
#include <llvm/Support/Program.h>
#include <llvm/Support/SourceMgr.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "error.h"
#include "frontend/refusal_messages.h"

namespace hlsc {
namespace {

namespace fs = std::filesystem;

constexpr char kWrapperName[] = "hlsc_unit.cpp";

/// A folder of its own under the system's temporary one, removed with everything in it.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::random_device random;
    path_ = fs::temp_directory_path() / fmt::format("hlsc-{:08x}{:08x}", random(), random());
    std::error_code error;
    fs::create_directories(path_, error);
    if (error) {
      throw Error({}, fmt::format(messages::kTemporary, path_.string(), error.message()));
    }
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  fs::path path_;
};

std::string read_text(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

/// Where the header lies; throws if no folder holds it.
std::string find_header(const UnitSource& source) {
  if (fs::exists(source.header)) return source.header;
  for (const std::string& folder : source.folders) {
    const fs::path path = fs::path(folder) / source.header;
    if (fs::exists(path)) return path.string();
  }
  throw Error({}, fmt::format(messages::kHeaderMissing, source.header));
}

/// Whether hls/ports.h is the one for lowering: the native one comes under the same name.
bool sees_lowered_language(const UnitSource& source) {
  for (const std::string& folder : source.folders) {
    const fs::path ports = fs::path(folder) / "hls" / "ports.h";
    if (fs::exists(ports)) {
      return read_text(ports.string()).find("namespace lowered") != std::string::npos;
    }
  }
  return false;
}

std::string wrapper(const UnitSource& source) {
  return fmt::format(
      "#include \"{1}\"\n"
      "using HlscUnit = {0};\n"
      "template <class T> concept HlscHasStep = requires(T& unit) {{ unit.step(); }};\n"
      "static_assert(HlscHasStep<HlscUnit>, \"hlsc: no step\");\n"
      "constinit HlscUnit {2}{{}};\n"
      "extern \"C\" void {3}(HlscUnit& unit) {{ unit.step(); }}\n",
      source.unit, source.header, kInitialUnit, kStepFunction);
}

/// The first diagnostic of clang's that points into the small source file, without its place.
std::string wrapper_diagnostic(const std::string& diagnostics) {
  std::istringstream lines(diagnostics);
  for (std::string line; std::getline(lines, line);) {
    const auto name = line.find(kWrapperName);
    const auto error = line.find("error: ");
    if (name != std::string::npos && error != std::string::npos && name < error) {
      return line.substr(error + 7);
    }
  }
  return {};
}

/// clang's diagnostics without the small source file and without the folders of this machine.
std::string readable(const UnitSource& source, const std::string& diagnostics) {
  std::istringstream lines(diagnostics);
  std::string text;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line.find(kWrapperName) != std::string::npos) continue;
    for (const std::string& folder : source.folders) {
      const std::string prefix = (fs::path(folder) / "").string();
      const auto at = line.find(prefix);
      if (at != std::string::npos) line.erase(at, prefix.size());
    }
    text += "\n" + line;
  }
  return text;
}

[[noreturn]] void report(const UnitSource& source, const std::string& diagnostics) {
  if (diagnostics.find("hlsc: no step") != std::string::npos) {
    throw Error({source.header, 0}, fmt::format(messages::kNoStep, source.unit));
  }
  const std::string own = wrapper_diagnostic(diagnostics);
  if (!own.empty()) {
    throw Error({source.header, 0},
                fmt::format(messages::kUnitMissing, source.unit, source.header, own));
  }
  throw Error({}, fmt::format(messages::kClangFailed, readable(source, diagnostics)));
}

/// The files of a make rule "target: file \ file ...", in which blanks of a name are escaped.
std::vector<std::string> read_dependencies(const std::string& path) {
  const std::string rule = read_text(path);
  std::vector<std::string> files;
  std::string name;
  for (std::size_t i = rule.find(": ") + 2; i <= rule.size(); ++i) {
    const char c = i < rule.size() ? rule[i] : ' ';
    if (c == '\\' && i + 1 < rule.size() && rule[i + 1] != '\n') {
      name += rule[++i];
    } else if (c == ' ' || c == '\n' || c == '\\') {
      if (!name.empty() && fs::path(name).filename() != kWrapperName) files.push_back(name);
      name.clear();
    } else {
      name += c;
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Runs clang on a file with these arguments besides those that units and precompiled headers
/// share.
void run_clang(const UnitSource& source, const TemporaryFolder& folder, const std::string& input,
               const std::string& output, const std::vector<std::string>& own) {
  const auto clang = llvm::sys::findProgramByName(source.clang);
  if (!clang) throw Error({}, fmt::format(messages::kClangMissing, source.clang));
  std::vector<std::string> args = {*clang};
  for (const char* flag :
       {"-std=c++20", "-O2", "-Xclang", "-disable-llvm-passes", "-fno-exceptions", "-fno-rtti",
        "-fno-builtin", "-fno-threadsafe-statics", "-g", "-fstandalone-debug",
        "-fno-caret-diagnostics", "-fno-color-diagnostics", "-DNDEBUG", "-Wno-bit-int-extension",
        "-w", "-fpch-instantiate-templates", "-c"}) {
    args.emplace_back(flag);
  }
  for (const std::string& include : source.folders) args.push_back("-I" + include);
  args.insert(args.end(), source.clang_args.begin(), source.clang_args.end());
  args.insert(args.end(), own.begin(), own.end());
  args.insert(args.end(), {"-o", output, input});

  const std::string diagnostics = folder.file("diagnostics");
  const std::vector<llvm::StringRef> views(args.begin(), args.end());
  const std::optional<llvm::StringRef> redirects[] = {std::nullopt, std::nullopt,
                                                      llvm::StringRef(diagnostics)};
  if (llvm::sys::ExecuteAndWait(*clang, views, std::nullopt, redirects) != 0) {
    report(source, read_text(diagnostics));
  }
}

}  // namespace

CompiledUnit compile_unit(const UnitSource& source, llvm::LLVMContext& context) {
  find_header(source);
  if (!sees_lowered_language(source)) throw Error({}, messages::kLanguageMissing);
  const TemporaryFolder folder;
  const std::string input = folder.file(kWrapperName);
  const std::string output = folder.file("unit.bc");
  const std::string dependencies = folder.file("dependencies");
  std::ofstream(input) << wrapper(source);
  std::vector<std::string> own = {"-emit-llvm", "-MD", "-MF", dependencies};
  if (const std::string& headers = source.precompiled; !headers.empty()) {
    if (!fs::exists(headers)) {
      throw Error({}, fmt::format(messages::kNotPrecompiled, headers, headers));
    }
    own.insert(own.end(), {"-include-pch", headers});
  }
  run_clang(source, folder, input, output, own);

  llvm::SMDiagnostic parse;
  CompiledUnit compiled;
  compiled.module = llvm::parseIRFile(output, parse, context);
  if (!compiled.module) throw Error({}, parse.getMessage().str());
  compiled.includes = read_dependencies(dependencies);
  return compiled;
}

void precompile(const UnitSource& source, const std::string& file) {
  run_clang(source, TemporaryFolder(), find_header(source), file, {"-x", "c++-header"});
}

}  // namespace hlsc
