// SPDX-License-Identifier: GPL-3.0-or-later
// Faults for a program, by LD_PRELOAD (glibc). IMPINGE_FAULT is the kind and a number n:
//   memory n     the n-th request for memory gets none, nor does the next, since operator new asks twice
//   memories n   that and all later ones get none
//   bytes n      regular files take n bytes together, as on a disk that fills
//   change n     the n-th change of a file or folder (creating, writing, syncing, renaming, linking) is
//                refused
//   look n       before the n-th look at files IMPINGE_VICTIM is changed, as IMPINGE_DEED says
//   machine n    the machine has n MiB of memory
// Counted is from main() on. IMPINGE_COUNTS names a file for the numbers of requests, bytes, changes and
// looks of a run.
#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/sysinfo.h>
#include <sys/uio.h>
#include <unistd.h>

// NOLINTBEGIN(readability-identifier-naming): names of glibc
extern "C" {
void* __libc_malloc(size_t size);
void* __libc_calloc(size_t count, size_t size);
void* __libc_realloc(void* old, size_t size);
void* __libc_memalign(size_t alignment, size_t size);
}

namespace {

using Main = int (*)(int, char**, char**);

std::string_view kind;
long at = 0;
std::atomic<bool> counting{false};
std::atomic<long> requests{0};
std::atomic<long> bytes{0};
std::atomic<long> changes{0};
std::atomic<long> looks{0};
Main real_main = nullptr;

template <class Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

int refused(int error) {
  errno = error;
  return -1;
}

bool no_memory() {
  if (!counting) return false;
  const long n = ++requests;
  const bool none = (kind == "memory" && (n == at || n == at + 1)) || (kind == "memories" && n >= at);
  if (none) errno = ENOMEM;
  return none;
}

bool no_change() { return counting && ++changes == at && kind == "change"; }

void look() {
  if (!counting || ++looks != at || kind != "look") return;
  const char* const victim = std::getenv("IMPINGE_VICTIM");
  const std::string_view deed = std::getenv("IMPINGE_DEED");
  struct stat now {};
  if (::syscall(SYS_newfstatat, AT_FDCWD, victim, &now, 0) != 0) return;
  if (deed == "removed" || deed == "a folder") ::syscall(SYS_unlink, victim);
  if (deed == "a folder") ::syscall(SYS_mkdir, victim, 0755);
  if (deed == "halved") ::syscall(SYS_truncate, victim, now.st_size / 2);
  if (deed == "emptied") ::syscall(SYS_truncate, victim, 0);
  if (deed == "doubled") ::syscall(SYS_truncate, victim, 2 * now.st_size);
}

bool is_file(int handle) {
  struct stat now {};
  return handle > 2 && ::fstat(handle, &now) == 0 && S_ISREG(now.st_mode);
}

// Of these bytes those for which there is room; -1: none.
long taken(int handle, long wanted) {
  if (!counting || !is_file(handle)) return wanted;
  if (no_change()) return -1;
  const long before = bytes.fetch_add(wanted);
  if (kind != "bytes" || before + wanted <= at) return wanted;
  return before < at ? at - before : -1;
}

// Name and number of IMPINGE_FAULT.
void read_fault() {
  const char* const fault = std::getenv("IMPINGE_FAULT");
  if (fault == nullptr) return;
  kind = fault;
  const std::size_t end = kind.find(' ');
  at = std::atol(fault + end);
  kind = kind.substr(0, end);
}

int counted_main(int argc, char** argv, char** environment) {
  read_fault();
  counting = true;
  return real_main(argc, argv, environment);
}

struct Report {
  ~Report() {
    counting = false;
    const char* const name = std::getenv("IMPINGE_COUNTS");
    std::FILE* const file = name == nullptr ? nullptr : std::fopen(name, "w");
    if (file == nullptr) return;
    std::fprintf(file, "%ld %ld %ld %ld\n", requests.load(), bytes.load(), changes.load(), looks.load());
    std::fclose(file);
  }
} report;

}  // namespace

extern "C" {

int __libc_start_main(Main main, int argc, char** argv, void (*first)(), void (*last)(), void (*linker)(),
                      void* end) {
  real_main = main;
  return next<decltype(&__libc_start_main)>("__libc_start_main")(counted_main, argc, argv, first, last,
                                                                 linker, end);
}

void* malloc(size_t size) { return no_memory() ? nullptr : __libc_malloc(size); }
void* calloc(size_t count, size_t size) { return no_memory() ? nullptr : __libc_calloc(count, size); }
void* realloc(void* old, size_t size) { return no_memory() ? nullptr : __libc_realloc(old, size); }
void* aligned_alloc(size_t alignment, size_t size) {
  return no_memory() ? nullptr : __libc_memalign(alignment, size);
}
int posix_memalign(void** to, size_t alignment, size_t size) {
  void* const got = no_memory() ? nullptr : __libc_memalign(alignment, size);
  if (got != nullptr) *to = got;
  return got == nullptr ? ENOMEM : 0;
}

int sysinfo(struct sysinfo* machine) {
  const auto done = static_cast<int>(::syscall(SYS_sysinfo, machine));
  if (done == 0 && kind == "machine") {
    machine->totalram = (static_cast<unsigned long>(at) << 20U) / machine->mem_unit;
    machine->totalswap = 0;
  }
  return done;
}

ssize_t write(int handle, const void* data, size_t size) {
  const long count = taken(handle, static_cast<long>(size));
  return count < 0 ? refused(ENOSPC) : ::syscall(SYS_write, handle, data, count);
}
ssize_t writev(int handle, const iovec* parts, int count) {
  long wanted = 0;
  for (int k = 0; k < count; ++k) wanted += static_cast<long>(parts[k].iov_len);
  const long room = taken(handle, wanted);
  if (room < 0) return refused(ENOSPC);
  if (room == wanted) return ::syscall(SYS_writev, handle, parts, count);
  return ::syscall(SYS_write, handle, parts[0].iov_base, std::min(room, static_cast<long>(parts[0].iov_len)));
}
int fsync(int handle) {
  return no_change() ? refused(ENOSPC) : static_cast<int>(::syscall(SYS_fsync, handle));
}
int rename(const char* from, const char* to) {
  return no_change() ? refused(ENOSPC) : static_cast<int>(::syscall(SYS_rename, from, to));
}
int link(const char* from, const char* to) {
  return no_change() ? refused(ENOSPC) : static_cast<int>(::syscall(SYS_link, from, to));
}
int mkdir(const char* name, mode_t mode) {
  return no_change() ? refused(ENOSPC) : static_cast<int>(::syscall(SYS_mkdir, name, mode));
}

int open(const char* name, int flags, ...) {
  va_list more;
  va_start(more, flags);
  const unsigned mode = (flags & O_CREAT) != 0 ? va_arg(more, unsigned) : 0;
  va_end(more);
  if ((flags & O_CREAT) == 0) look();
  if ((flags & O_CREAT) != 0 && no_change()) return refused(ENOSPC);
  return static_cast<int>(::syscall(SYS_openat, AT_FDCWD, name, flags, mode));
}
std::FILE* fopen(const char* name, const char* mode) {
  if (mode[0] == 'r') look();
  if (mode[0] != 'r' && no_change()) {
    errno = ENOSPC;
    return nullptr;
  }
  return next<decltype(&std::fopen)>("fopen")(name, mode);
}
std::FILE* fopen64(const char* name, const char* mode) { return fopen(name, mode); }
ssize_t read(int handle, void* data, size_t size) {
  if (is_file(handle)) look();
  return ::syscall(SYS_read, handle, data, size);
}
int stat(const char* name, struct stat* found) {
  look();
  return static_cast<int>(::syscall(SYS_newfstatat, AT_FDCWD, name, found, 0));
}

}  // extern "C"
// NOLINTEND(readability-identifier-naming)
