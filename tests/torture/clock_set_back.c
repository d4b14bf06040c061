// SPDX-License-Identifier: BSD-3-Clause
// A library for LD_PRELOAD: the clock of the day is set back by an hour at every tenth look at it, and forward by two at every hundredth. The clock that only runs forward does so.
#define _GNU_SOURCE
#include <sys/syscall.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

static long looks = 0, moved = 0;

int clock_gettime(clockid_t clock, struct timespec* now)
{
  const int result = (int)syscall(SYS_clock_gettime, clock, now);
  if (clock != CLOCK_REALTIME) return result;
  const long look = __atomic_add_fetch(&looks, 1, __ATOMIC_RELAXED);
  if (look % 10 == 0) __atomic_add_fetch(&moved, look % 100 == 0 ? 7200 : -3600, __ATOMIC_RELAXED);
  now->tv_sec += moved;
  return result;
}

int gettimeofday(struct timeval* now, void* zone)
{
  struct timespec time;
  (void)zone;
  const int result = clock_gettime(CLOCK_REALTIME, &time);
  now->tv_sec = time.tv_sec;
  now->tv_usec = time.tv_nsec / 1000;
  return result;
}

time_t time(time_t* now)
{
  struct timespec time;
  clock_gettime(CLOCK_REALTIME, &time);
  if (now != NULL) *now = time.tv_sec;
  return time.tv_sec;
}
