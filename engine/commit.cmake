# Writes the source file that says which commit is built, if that has changed. -DSOURCE_DIR=... -DOUTPUT=...
# Where the sources are no git repository, the commit is empty.
find_package(Git QUIET)
set(commit "")
if(GIT_FOUND AND EXISTS ${SOURCE_DIR}/.git)
  execute_process(
    COMMAND ${GIT_EXECUTABLE} -C ${SOURCE_DIR} describe --always --exclude=* --abbrev=10 --dirty=+changes
    OUTPUT_VARIABLE commit
    OUTPUT_STRIP_TRAILING_WHITESPACE
    ERROR_QUIET)
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT [[
#include "report/commit.h"

namespace flyrock {

const char* source_commit() { return "@commit@"; }

}  // namespace flyrock
]] @ONLY)
