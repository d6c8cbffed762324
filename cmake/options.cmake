# Warnings, optimisation and sanitizers, shared by every target through the interface library pf_options.
add_library(pf_options INTERFACE)
target_compile_options(pf_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Woverloaded-virtual)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 14)
  # False reports inside the compiler's own AVX-512 headers (GCC bug 105593) and std::string (GCC bug 105651).
  target_compile_options(pf_options INTERFACE -Wno-maybe-uninitialized -Wno-uninitialized -Wno-restrict)
endif()
# Packs of eight doubles are passed between our own functions only, all compiled alike: their ABI is nobody else's.
target_compile_options(pf_options INTERFACE -Wno-psabi)
if(PUSHFORWARD_WERROR)
  target_compile_options(pf_options INTERFACE -Werror)
endif()
if(PUSHFORWARD_NATIVE)
  target_compile_options(pf_options INTERFACE -march=native)
endif()
# The same sums in the same order on every machine that runs the same binary: no contraction-free guarantee is
# needed, but no re-association either, so never -ffast-math. These two only drop errno and trap bookkeeping.
target_compile_options(pf_options INTERFACE -fno-math-errno -fno-trapping-math)
if(PUSHFORWARD_SANITIZE)
  target_compile_options(pf_options INTERFACE -fsanitize=${PUSHFORWARD_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(pf_options INTERFACE -fsanitize=${PUSHFORWARD_SANITIZE})
endif()
