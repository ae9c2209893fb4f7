// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Counts calls that a servo tick must not make. Overrides of functions of the C library count allocations and locks,
// and a filter of the kernel counts system calls. Only one source file of a test program may include this header, as it
// defines malloc().
#include <dlfcn.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <pthread.h>
#include <signal.h>
#include <stddef.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>
#include <atomic>
#include <cerrno>
#include <vector>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define HANDWHEEL_SANITIZED 1
#else
#define HANDWHEEL_SANITIZED 0
#endif

namespace handwheel::test {

inline thread_local bool isCounting = false;
inline std::atomic<int> allocations{0};
inline std::atomic<int> locks{0};
inline std::atomic<int> systemCalls{0};
inline std::atomic<long> lastSystemCall{-1};

}  // namespace handwheel::test

#if !HANDWHEEL_SANITIZED
extern "C" {
void* __libc_malloc(size_t);
void* __libc_calloc(size_t, size_t);
void* __libc_realloc(void*, size_t);
void __libc_free(void*);

void* malloc(size_t size) {
  if (handwheel::test::isCounting) ++handwheel::test::allocations;
  return __libc_malloc(size);
}
void* calloc(size_t count, size_t size) {
  if (handwheel::test::isCounting) ++handwheel::test::allocations;
  return __libc_calloc(count, size);
}
void* realloc(void* block, size_t size) {
  if (handwheel::test::isCounting) ++handwheel::test::allocations;
  return __libc_realloc(block, size);
}
void free(void* block) {
  if (handwheel::test::isCounting && block) ++handwheel::test::allocations;
  __libc_free(block);
}

int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept {
  using Lock = int (*)(pthread_mutex_t*);
  static const std::atomic<Lock> lock{reinterpret_cast<Lock>(dlsym(RTLD_NEXT, "pthread_mutex_lock"))};
  if (handwheel::test::isCounting) ++handwheel::test::locks;
  return lock.load(std::memory_order_relaxed)(mutex);
}
}
#endif

namespace handwheel::test {

inline void onSystemCall(int, siginfo_t* info, void* context) {
  ++systemCalls;
  lastSystemCall = info->si_syscall;
#if defined(__x86_64__)
  static_cast<ucontext_t*>(context)->uc_mcontext.gregs[REG_RAX] = -ENOSYS;
#else
  (void)context;  // a refused call returns an arbitrary value here
#endif
}

// Forbids system calls on this thread: from now on they are counted and refused, except for waiting and ending a
// thread. Returns false if the kernel does not support the filter.
inline bool forbidSystemCalls() {
  struct sigaction action {};
  action.sa_sigaction = onSystemCall;
  action.sa_flags = SA_SIGINFO;
  sigaction(SIGSYS, &action, nullptr);
  const std::vector<int> allowed{SYS_clock_nanosleep, SYS_rt_sigreturn, SYS_rt_sigprocmask,
                                 SYS_madvise,         SYS_munmap,       SYS_exit};
  std::vector<sock_filter> filter;
  filter.push_back(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)));
  for (const int number : allowed) {
    filter.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<unsigned>(number), 0, 1));
    filter.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
  }
  filter.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_TRAP));
  const sock_fprog program{static_cast<unsigned short>(filter.size()), filter.data()};
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 && prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

}  // namespace handwheel::test
