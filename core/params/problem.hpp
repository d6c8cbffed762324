// What is wrong with the user's input, and how that is thrown.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace pf {

/// One thing that is wrong with an input, and what would be right.
struct Problem {
  std::string pointer;  ///< JSON pointer, "" for the whole document
  std::string found;    ///< what is there
  std::string allowed;  ///< what may be there; nearest known key, range with unit, choices
  int line = 0;         ///< 1-based line in the file, 0 when unknown
};

/// "/time/step, line 7: found -1; allowed: a number > 0 [s]".
std::string to_string(const Problem& problem);

/// The user's input is wrong. The only exception of core that is the user's to mend.
class InputError : public std::runtime_error {
 public:
  InputError(std::string file, std::vector<Problem> problems);
  const std::string& file() const { return file_; }
  const std::vector<Problem>& problems() const { return problems_; }  ///< at least one

 private:
  std::string file_;
  std::vector<Problem> problems_;
};

/// A file could not be read or written (exit status 4).
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace pf
