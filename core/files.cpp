#include "core/files.hpp"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <system_error>

#include "core/params/problem.hpp"

namespace pf {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse(const fs::path& path, const char* what, int error) {
  throw FileError(path.string() + ": " + what + ": " + std::generic_category().message(error));
}

}  // namespace

void OutputFile::Closer::operator()(std::FILE* file) const {
  std::fclose(file);
}

OutputFile::OutputFile(fs::path path, Mode mode) : path_(std::move(path)) {
  file_.reset(std::fopen(path_.c_str(), mode == Mode::replace ? "wb" : "ab"));
  if (file_ == nullptr) refuse(path_, "cannot be written", errno);
}

void OutputFile::write(std::string_view bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size())
    refuse(path_, "could not be written to the end", errno);
}

void OutputFile::flush() {
  if (std::fflush(file_.get()) != 0) refuse(path_, "could not be written to the end", errno);
}

void OutputFile::close() {
  if (file_ == nullptr) return;
  flush();
  if (std::fclose(file_.release()) != 0) refuse(path_, "could not be closed", errno);
}

void write_atomically(const fs::path& path, std::string_view bytes) {
  fs::path temporary = path;
  temporary += ".part" + std::to_string(::getpid());
  try {
    OutputFile file(temporary);
    file.write(bytes);
    file.close();
  } catch (const FileError&) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    throw;
  }
  std::error_code error;
  fs::rename(temporary, path, error);
  if (error) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    refuse(path, "cannot be replaced", error.value());
  }
}

std::string read_file(const fs::path& path) {
  errno = 0;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (file == nullptr) refuse(path, "cannot be read", errno);
  std::string bytes;
  std::array<char, 1 << 16> buffer{};
  while (const std::size_t got = std::fread(buffer.data(), 1, buffer.size(), file.get()))
    bytes.append(buffer.data(), got);
  if (std::ferror(file.get()) != 0) refuse(path, "cannot be read", errno);
  return bytes;
}

void make_folder(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) refuse(path, "this folder cannot be made", error.value());
}

std::filesystem::path free_file(const std::filesystem::path& folder, const std::string& stem,
                                const std::string& extension) {
  std::error_code error;
  for (int k = 1;; ++k) {
    std::string name = stem;
    if (k > 1) name.append("-").append(std::to_string(k));
    std::filesystem::path file = folder / name.append(extension);
    if (!std::filesystem::exists(file, error)) return file;
  }
}

void append_number(std::string& text, double value) {
  std::array<char, 32> digits{};
  const auto [end, error] =
      std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::general, 17);
  text.append(digits.data(), end);
}

std::string file_number(long number) {
  std::array<char, 24> digits{};
  std::snprintf(digits.data(), digits.size(), "%06ld", number);
  return digits.data();
}

}  // namespace pf
