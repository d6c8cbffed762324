// Files being written, with errors that name the file and the system's reason.
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace pf {

/// Every member throws FileError (exit status 4) when the system refuses: no permission, disk full.
class OutputFile {
 public:
  enum class Mode { replace, append };
  explicit OutputFile(std::filesystem::path path, Mode mode = Mode::replace);
  void write(std::string_view bytes);
  /// Hands everything to the system: what was written before a crash is kept.
  void flush();
  /// Also done by the destructor, which cannot report.
  void close();
  const std::filesystem::path& path() const { return path_; }

 private:
  struct Closer {
    void operator()(std::FILE* file) const;
  };
  std::filesystem::path path_;
  std::unique_ptr<std::FILE, Closer> file_;
};

/// The whole file or none of it: written beside it under another name, then renamed. Throws FileError.
void write_atomically(const std::filesystem::path& path, std::string_view bytes);
/// Throws FileError.
std::string read_file(const std::filesystem::path& path);
/// Makes the folder and those above it. Throws FileError.
void make_folder(const std::filesystem::path& path);

/// The first of stem.ext, stem-2.ext, stem-3.ext, ... in `folder` that does not exist; `extension` with its dot.
std::filesystem::path free_file(const std::filesystem::path& folder, const std::string& stem,
                                const std::string& extension);

/// Appends `value` with 17 significant digits: reading it back gives the same double.
void append_number(std::string& text, double value);
/// "000042": the number of a frame or checkpoint in file names.
std::string file_number(long number);

}  // namespace pf
