// SPDX-License-Identifier: BSD-3-Clause
// A library for LD_PRELOAD: the N-th call by which a program changes files fails. Counted are, on files (not on terminals, pipes or standard error):
// open for writing, write, pwrite, writev, sendfile, fsync, fdatasync, ftruncate, close of what was open for writing, rename, mkdir. Environment:
//   FAULT_IN      the name of the program that is meant; others, such as its children, run as ever
//   FAULT_AT      N, from 1; 0: none fails, all are told
//   FAULT_HOW     ENOSPC, EIO, EFBIG with its signal (this call), SHORT (a write takes half, all other calls pass), FULL (the same, and all that
//                 follow fail with ENOSPC; so does this one where it is no write), KILL (the program is killed before it; unlink and rmdir count, too)
//   FAULT_ONE     set: only the first process of that name is meant, not its children
//   FAULT_TOLD    a file that gets a line for each call that failed: its name and the path
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/sendfile.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

static long at = -1, count = 0;
static int reason = 0, full = 0, halves = 0, kills = 0;  // full: a disk that is full from then on

// The number of the first process goes to its children, and to what it becomes by exec.
static int is_the_first(void)
{
  char own[24];
  snprintf(own, sizeof own, "%ld", (long)getpid());
  setenv("FAULT_FIRST", own, 0);
  return strcmp(getenv("FAULT_FIRST"), own) == 0;
}

__attribute__((constructor)) static void begin(void)
{
  const char *in = getenv("FAULT_IN"), *n = getenv("FAULT_AT"), *how = getenv("FAULT_HOW");
  if (in == NULL || n == NULL || how == NULL || strcmp(in, program_invocation_short_name) != 0) return;
  if (getenv("FAULT_ONE") != NULL && !is_the_first()) return;
  at = atol(n);
  halves = strcmp(how, "SHORT") == 0;
  full = strcmp(how, "FULL") == 0;
  kills = strcmp(how, "KILL") == 0;
  reason = strcmp(how, "EIO") == 0 ? EIO : strcmp(how, "EFBIG") == 0 ? EFBIG : ENOSPC;
}

static void tell(const char* call, const char* path)
{
  char line[4200];
  const char* told = getenv("FAULT_TOLD");
  const int size = snprintf(line, sizeof line, "%s %s\n", call, path);
  const int to = told == NULL ? -1 : (int)syscall(SYS_openat, AT_FDCWD, told, O_WRONLY | O_CREAT | O_APPEND, 0666);
  if (to < 0) return;
  if (syscall(SYS_write, to, line, size) != size) abort();
  syscall(SYS_close, to);
}

// True where this call is to fail; errno says why then.
static int fails(const char* call, const char* path)
{
  if (at < 0) return 0;
  const long n = __atomic_add_fetch(&count, 1, __ATOMIC_RELAXED);
  if (at == 0) tell(call, path);
  if (at == 0 || n < at || (n > at && !full) || (halves && !full)) return 0;
  tell(call, path);
  if (kills) raise(SIGKILL);
  if (reason == EFBIG) raise(SIGXFSZ);
  errno = reason;
  return 1;
}

static int fails_in(const char* call, int file)
{
  char link[40], path[4096];
  snprintf(link, sizeof link, "/proc/self/fd/%d", file);
  const ssize_t size = readlink(link, path, sizeof path - 1);
  path[size < 0 ? 0 : size] = '\0';
  return fails(call, path);
}

static int is_file_to_write(int file)
{
  struct stat status;
  const int flags = fcntl(file, F_GETFL);
  return at >= 0 && file != STDERR_FILENO && flags >= 0 && (flags & O_ACCMODE) != O_RDONLY && fstat(file, &status) == 0 &&
         S_ISREG(status.st_mode);
}

// How much of a write of `size` bytes is to be tried: the half of it where it is the one. 0: none, it fails.
static size_t tried(int file, size_t size)
{
  if ((halves || full) && size > 1 && count + 1 == at) return ++count, size / 2;
  return fails_in("write", file) ? 0 : size;
}

#define REAL(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

ssize_t write(int file, const void* bytes, size_t size)
{
  if (!is_file_to_write(file)) return REAL(write)(file, bytes, size);
  const size_t part = tried(file, size);
  return part == 0 && size > 0 ? -1 : REAL(write)(file, bytes, part);
}

ssize_t pwrite64(int file, const void* bytes, size_t size, off64_t offset)
{
  if (!is_file_to_write(file)) return REAL(pwrite64)(file, bytes, size, offset);
  const size_t part = tried(file, size);
  return part == 0 && size > 0 ? -1 : REAL(pwrite64)(file, bytes, part, offset);
}

ssize_t pwrite(int file, const void* bytes, size_t size, off_t offset)
{
  return pwrite64(file, bytes, size, offset);
}

ssize_t writev(int file, const struct iovec* parts, int number)
{
  if (!is_file_to_write(file)) return REAL(writev)(file, parts, number);
  const size_t part = tried(file, (size_t)number);
  return part == 0 && number > 0 ? -1 : REAL(writev)(file, parts, (int)part);
}

ssize_t sendfile(int to, int from, off_t* offset, size_t size)
{
  return is_file_to_write(to) && fails_in("sendfile", to) ? -1 : REAL(sendfile)(to, from, offset, size);
}

int fsync(int file)
{
  return fails_in("fsync", file) ? -1 : REAL(fsync)(file);
}

int fdatasync(int file)
{
  return fails_in("fdatasync", file) ? -1 : REAL(fdatasync)(file);
}

// A full disk lets files be made shorter.
int ftruncate64(int file, off64_t size)
{
  return fails_in("ftruncate", file) && !full ? -1 : REAL(ftruncate64)(file, size);
}

int ftruncate(int file, off_t size)
{
  return ftruncate64(file, size);
}

int rename(const char* from, const char* to)
{
  return fails("rename", to) ? -1 : REAL(rename)(from, to);
}

int mkdir(const char* path, mode_t mode)
{
  return fails("mkdir", path) ? -1 : REAL(mkdir)(path, mode);
}

int unlink(const char* path)
{
  if (kills) fails("unlink", path);
  return REAL(unlink)(path);
}

int unlinkat(int folder, const char* path, int flags)
{
  if (kills) fails("unlink", path);
  return REAL(unlinkat)(folder, path, flags);
}

int rmdir(const char* path)
{
  if (kills) fails("rmdir", path);
  return REAL(rmdir)(path);
}

// The descriptor is gone even where close() reports an error.
int close(int file)
{
  const int failed = is_file_to_write(file) && fails_in("close", file);
  const int result = REAL(close)(file);
  if (failed) errno = reason;
  return failed ? -1 : result;
}

static int opens_to_write(const char* path, int flags)
{
  return (flags & O_ACCMODE) != O_RDONLY && strcmp(path, "/dev/null") != 0;
}

static mode_t mode_of(int flags, va_list rest)
{
  return (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
}

int open64(const char* path, int flags, ...)
{
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = mode_of(flags, rest);
  va_end(rest);
  return opens_to_write(path, flags) && fails("open", path) ? -1 : REAL(open64)(path, flags, mode);
}

int open(const char* path, int flags, ...)
{
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = mode_of(flags, rest);
  va_end(rest);
  return open64(path, flags, mode);
}

int openat64(int folder, const char* path, int flags, ...)
{
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = mode_of(flags, rest);
  va_end(rest);
  return opens_to_write(path, flags) && fails("open", path) ? -1 : REAL(openat64)(folder, path, flags, mode);
}

int openat(int folder, const char* path, int flags, ...)
{
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = mode_of(flags, rest);
  va_end(rest);
  return openat64(folder, path, flags, mode);
}

// What the C library's own streams open, such as those of std::ofstream.
FILE* fopen64(const char* path, const char* mode)
{
  return strpbrk(mode, "wa+") != NULL && fails("fopen", path) ? NULL : REAL(fopen64)(path, mode);
}

FILE* fopen(const char* path, const char* mode)
{
  return fopen64(path, mode);
}
