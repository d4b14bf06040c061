// SPDX-License-Identifier: BSD-3-Clause
// A library for LD_PRELOAD: the N-th request for memory of a program fails, counted from the beginning of main. Environment:
//   FAULT_IN      the name of the program that is meant; others, such as its children, run as ever
//   FAULT_AT      N, from 1; 0: none fails, and of each it is told by which way the program came to it
//   FAULT_HOW     ONCE, or EVER: so do all that follow
//   FAULT_TOLD    a file that gets a line of who asked where one fails: LIBRARY:FUNCTION, or LIBRARY+PLACE, the innermost first, and one of who ends the program by a signal or exit();
//                 where none does, a line of each request: a number for its way
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <execinfo.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

extern void* __libc_malloc(size_t);
extern void* __libc_calloc(size_t, size_t);
extern void* __libc_realloc(void*, size_t);
extern void* __libc_memalign(size_t, size_t);

static long at = -1, count = 0;
static int ever = 0, told = -1;
static FILE* ways = NULL;
enum { WAY = 12 };  // calls

static void tell(void)
{
  void* frames[40];
  char text[4000];
  int size = 0;
  const int depth = backtrace(frames, 40);
  for (int k = 2; k < depth && size < 3700; ++k) {
    Dl_info info;
    if (dladdr(frames[k], &info) == 0) continue;
    const char *file = strrchr(info.dli_fname, '/'), *name = file == NULL ? info.dli_fname : file + 1;
    size += info.dli_sname == NULL ? sprintf(text + size, "%.40s+%lx ", name, (unsigned long)((char*)frames[k] - (char*)info.dli_fbase))
                                   : sprintf(text + size, "%.40s:%.200s ", name, info.dli_sname);
  }
  text[size++] = '\n';
  if (syscall(SYS_write, told, text, size) != size) _exit(99);
}

static void tell_of_signal(int signal)
{
  at = -1;
  tell();
  raise(signal);  // SA_RESETHAND
}

static void tell_of_exit(void)
{
  if (at > 0 && count >= at) at = -1, tell();
}

// A number for the calls that led here.
static void tell_way(void)
{
  void* frames[WAY + 2];
  unsigned long way = 14695981039346656037UL;
  const int depth = backtrace(frames, WAY + 2);
  for (int k = 2; k < depth; ++k) way = (way ^ (unsigned long)frames[k]) * 1099511628211UL;
  fprintf(ways, "%lx\n", way);
}

static int fails(void)
{
  if (at < 0) return 0;
  const long n = __atomic_add_fetch(&count, 1, __ATOMIC_RELAXED);
  if (at == 0) {
    at = -1;
    tell_way();
    at = 0;
  }
  if (at == 0 || n < at || (n > at && !ever)) return 0;
  if (n == at) {
    const long once = at;
    at = -1;  // what tells may ask for memory
    tell();
    at = once;
  }
  errno = ENOMEM;
  return 1;
}

void* malloc(size_t size)
{
  return fails() ? NULL : __libc_malloc(size);
}

void* calloc(size_t number, size_t size)
{
  return fails() ? NULL : __libc_calloc(number, size);
}

void* realloc(void* old, size_t size)
{
  return size > 0 && fails() ? NULL : __libc_realloc(old, size);
}

void* memalign(size_t alignment, size_t size)
{
  return fails() ? NULL : __libc_memalign(alignment, size);
}

void* aligned_alloc(size_t alignment, size_t size)
{
  return memalign(alignment, size);
}

int posix_memalign(void** memory, size_t alignment, size_t size)
{
  if (fails()) return ENOMEM;
  *memory = __libc_memalign(alignment, size);
  return *memory == NULL ? ENOMEM : 0;
}

// Of files, too; the C library's own requests for its heap do not come here.
void* mmap64(void* where, size_t size, int protection, int flags, int file, off64_t offset)
{
  if (fails()) return MAP_FAILED;
  return (void*)syscall(SYS_mmap, where, size, protection, flags, file, offset);
}

void* mmap(void* where, size_t size, int protection, int flags, int file, off_t offset)
{
  return mmap64(where, size, protection, flags, file, offset);
}

static int (*own_main)(int, char**, char**);

static int counted_main(int argc, char** argv, char** environment)
{
  const char *in = getenv("FAULT_IN"), *n = getenv("FAULT_AT"), *how = getenv("FAULT_HOW"), *file = getenv("FAULT_TOLD");
  if (in != NULL && n != NULL && how != NULL && file != NULL && strcmp(in, program_invocation_short_name) == 0) {
    void* frames[4];
    backtrace(frames, 4);  // loads what it needs
    told = (int)syscall(SYS_openat, AT_FDCWD, file, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    ever = strcmp(how, "EVER") == 0;
    struct sigaction action = {.sa_handler = tell_of_signal, .sa_flags = (int)SA_RESETHAND | SA_NODEFER};
    const int deadly[] = {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL};
    for (int k = 0; k < 5; ++k) sigaction(deadly[k], &action, NULL);
    atexit(tell_of_exit);
    if (atol(n) == 0) ways = fdopen(told, "a");
    at = atol(n);
  }
  const int status = own_main(argc, argv, environment);
  at = -1;  // what follows is no part of it
  if (ways != NULL) fclose(ways);
  return status;
}

int __libc_start_main(int (*main)(int, char**, char**), int argc, char** argv, void (*begin)(void), void (*end)(void),
                      void (*end_of_loader)(void), void* stack)
{
  __typeof__(&__libc_start_main) real = (__typeof__(&__libc_start_main))dlsym(RTLD_NEXT, "__libc_start_main");
  own_main = main;
  return real(counted_main, argc, argv, begin, end, end_of_loader, stack);
}
