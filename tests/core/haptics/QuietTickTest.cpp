// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// A tick allocates nothing, takes no lock, and makes no system call but the wait: counted by functions of this program
// that stand before those of the C library, and by the kernel's filter of system calls on the ticking thread.
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
#include <QtTest>
#include <atomic>
#include <cerrno>
#include <thread>
#include <vector>

#include "HapticDevices.h"
#include "haptics/MouseDevice.h"
#include "haptics/ServoLoop.h"
#include "haptics/SimulatedDevice.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define HANDWHEEL_SANITIZED 1
#else
#define HANDWHEEL_SANITIZED 0
#endif

using namespace handwheel;
using namespace handwheel::test;

namespace {

thread_local bool isCounting = false;
std::atomic<int> allocations{0};
std::atomic<int> locks{0};
std::atomic<int> systemCalls{0};
std::atomic<long> lastSystemCall{-1};

}  // namespace

#if !HANDWHEEL_SANITIZED
extern "C" {
void* __libc_malloc(size_t);
void* __libc_calloc(size_t, size_t);
void* __libc_realloc(void*, size_t);
void __libc_free(void*);

void* malloc(size_t size) {
  if (isCounting) ++allocations;
  return __libc_malloc(size);
}
void* calloc(size_t count, size_t size) {
  if (isCounting) ++allocations;
  return __libc_calloc(count, size);
}
void* realloc(void* block, size_t size) {
  if (isCounting) ++allocations;
  return __libc_realloc(block, size);
}
void free(void* block) {
  if (isCounting && block) ++allocations;
  __libc_free(block);
}

int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept {
  using Lock = int (*)(pthread_mutex_t*);
  static const std::atomic<Lock> lock{reinterpret_cast<Lock>(dlsym(RTLD_NEXT, "pthread_mutex_lock"))};
  if (isCounting) ++locks;
  return lock.load(std::memory_order_relaxed)(mutex);
}
}
#endif

namespace {

void onSystemCall(int, siginfo_t* info, void* context) {
  ++systemCalls;
  lastSystemCall = info->si_syscall;
#if defined(__x86_64__)
  static_cast<ucontext_t*>(context)->uc_mcontext.gregs[REG_RAX] = -ENOSYS;
#else
  (void)context;  // the call returns its own number
#endif
}

// From here on, on this thread, any system call but waiting, and what a thread needs to end, is counted and refused.
// False where the kernel does not have it.
bool forbidSystemCalls() {
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

}  // namespace

class QuietTickTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    if (HANDWHEEL_SANITIZED) QSKIP("a sanitizer stands in the same place");
  }

  // So that the counters are known to count.
  void theCountersCount() {
    isCounting = true;
    std::vector<int> some(1000);
    static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
    pthread_mutex_lock(&mutex);
    pthread_mutex_unlock(&mutex);
    isCounting = false;
    QVERIFY(some.size() == 1000 && allocations > 0);
    QVERIFY(locks > 0);
    bool isForbidden = false;
    std::thread([&] {
      isForbidden = forbidSystemCalls();
      if (isForbidden) syscall(SYS_getppid);
    }).join();
    if (!isForbidden) QSKIP("this kernel filters no system calls");
    QVERIFY(systemCalls > 0);
  }

  // In contact, through the ramp, with the hand's dynamics, while scenes are exchanged by another thread.
  void aTickIsQuiet() {
    MonotonicClock clock;
    auto device = std::make_unique<SimulatedDevice>(
        simulatedDevice(), HandPath({{0.0, {-1, 0, 0}}, {0.2, {2, 0, 0}}, {0.6, {2, 0, 0}}}), clock);
    QVERIFY(device->open(Progress()).hasValue());
    Service service("servo");
    ServoLoop loop(std::move(device), {}, clock, service);
    loop.setScene(sceneOf(wall(0.5)));
    isSilentFor(loop, [&] { loop.setScene(sceneOf(wall(0.5), false)); });
  }

  // A device that is gone, and one that says NaN.
  void faultsAreQuietToo() {
    auto log = std::make_shared<ScriptedDevice::Log>();
    log->onRead = [](ScriptedDevice::Log& l) {
      l.state.status = l.reads % 7 == 0 ? DeviceStatus::Absent : DeviceStatus::Ready;
      l.state.position.x() = l.reads % 11 == 0 ? std::numeric_limits<double>::quiet_NaN() : 1.0;
    };
    MonotonicClock clock;
    Service service("servo");
    ServoLoop loop(std::make_unique<ScriptedDevice>(log), {}, clock, service);
    loop.setScene(sceneOf(wall(0.5)));
    isSilentFor(loop, [&] { loop.announceLeap(); });
  }

 private:
  // Runs 500 ticks under the counters, and `meanwhile` on this thread again and again.
  template <class Meanwhile>
  void isSilentFor(ServoLoop& loop, Meanwhile meanwhile) {
    allocations = locks = systemCalls = 0;
    std::atomic<bool> isDone{false};
    std::thread servo([&] {
      loop.runTicks(10);  // what is looked up when first called is
      forbidSystemCalls();
      isCounting = true;
      loop.runTicks(500);
      isCounting = false;
      isDone = true;
    });
    while (!isDone) {
      meanwhile();
      QThread::msleep(5);
    }
    servo.join();
    QCOMPARE(allocations.load(), 0);
    QCOMPARE(locks.load(), 0);
    QVERIFY2(systemCalls == 0, qPrintable(QString("system call %1").arg(lastSystemCall.load())));
    QCOMPARE(loop.latest().tick, std::uint64_t{509});
  }
};

QTEST_GUILESS_MAIN(QuietTickTest)
#include "QuietTickTest.moc"
