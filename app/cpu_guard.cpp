// A program compiled for the machine that built it dies of an illegal instruction elsewhere. This says so instead.
// It runs before every other static initialiser and is itself compiled for the oldest processor (CMakeLists.txt),
// so it uses nothing but system calls: an inline function of the standard library could be the other files' copy.
#include "app/cpu_guard.hpp"

#if defined(__x86_64__)
#include <string.h>
#include <unistd.h>

extern "C" const unsigned pushforward_needs;  // main.cpp, compiled like the rest

namespace {

void say(const char* text) {
  const ssize_t written = write(STDERR_FILENO, text, strlen(text));
  (void)written;
}

__attribute__((constructor(101))) void refuse_a_lesser_processor() {
  __builtin_cpu_init();
  const char* missing = nullptr;
#define PUSHFORWARD_CHECK(bit, feature) \
  if (((pushforward_needs >> (bit)) & 1u) != 0 && !__builtin_cpu_supports(feature)) missing = feature;
  PUSHFORWARD_CPU_FEATURES(PUSHFORWARD_CHECK)
#undef PUSHFORWARD_CHECK
  if (missing == nullptr) return;
  say("pushforward: this program was compiled for another processor: this one lacks ");
  say(missing);
  say(".\nBuild it here (./run.sh), or build one for every processor: cmake --preset portable && "
      "cmake --build --preset portable\n");
  _exit(2);
}

}  // namespace
#endif
