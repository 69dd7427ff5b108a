// A file system without locks, for LD_PRELOAD: flock(2) and the locks of fcntl(2) fail with the error number
// in FLYROCK_TEST_NO_FLOCK and FLYROCK_TEST_NO_FCNTL.

#include <dlfcn.h>
#include <fcntl.h>

#include <cerrno>
#include <cstdarg>
#include <cstdlib>

namespace {

/// Whether a function shall fail; sets errno.
bool fails(const char* variable) {
  const char* number = std::getenv(variable);
  if (!number) return false;
  errno = std::atoi(number);
  return true;
}

bool is_lock(int command) {
  return command == F_SETLK || command == F_SETLKW || command == F_GETLK || command == F_OFD_SETLK ||
         command == F_OFD_SETLKW || command == F_OFD_GETLK;
}

int pass_on(const char* name, int file, int command, void* argument) {
  if (is_lock(command) && fails("FLYROCK_TEST_NO_FCNTL")) return -1;
  using Function = int (*)(int, int, ...);
  return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name))(file, command, argument);
}

void* argument_of(std::va_list& list) { return va_arg(list, void*); }

}  // namespace

extern "C" {

// The name flock(2) is also that of a structure.
int failing_flock(int file, int operation) __asm__("flock");

int failing_flock(int file, int operation) {
  if (fails("FLYROCK_TEST_NO_FLOCK")) return -1;
  using Function = int (*)(int, int);
  return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, "flock"))(file, operation);
}

int fcntl(int file, int command, ...) {
  std::va_list list;
  va_start(list, command);
  void* argument = argument_of(list);
  va_end(list);
  return pass_on("fcntl", file, command, argument);
}

int fcntl64(int file, int command, ...) {
  std::va_list list;
  va_start(list, command);
  void* argument = argument_of(list);
  va_end(list);
  return pass_on("fcntl64", file, command, argument);
}

}  // extern "C"
