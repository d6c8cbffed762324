# Writes OUTPUT, the C++ file that holds the commit of the checkout at SOURCE ("unknown" outside of git).
set(commit "unknown")
if(GIT)
  execute_process(COMMAND ${GIT} rev-parse --short=12 HEAD WORKING_DIRECTORY ${SOURCE}
    OUTPUT_VARIABLE found OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(NOT failed)
    set(commit ${found})
  endif()
endif()
file(WRITE ${OUTPUT} "namespace pf::detail {\nextern const char* const commit;\nconst char* const commit = \"${commit}\";\n}  // namespace pf::detail\n")
