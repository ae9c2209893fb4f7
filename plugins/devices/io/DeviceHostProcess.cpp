// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/DeviceHostProcess.h"

#include "haptics/device/DeviceErrors.h"
#include "haptics/servo/RealTimeThread.h"
#include "io/FileStream.h"
#include "io/SessionHost.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace handwheel {

namespace {

constexpr int kGuardEnd = 3;        // the descriptor of its end of the socket
constexpr int kGuardPriority = 10;  // SCHED_FIFO priority, low among real-time threads
constexpr double kWait = 0.001;
constexpr int kWaits = 1000;  // after which it is killed

std::atomic<bool> stopped{false};

// The stream to a process, which ends with it.
class ProcessStream final : public ByteStream {
 public:
  ProcessStream(int descriptor, pid_t process)
      : m_stream(std::make_unique<FileStream>(descriptor)), m_process(process) {}
  ~ProcessStream() override {
    m_stream.reset();
    SteadyClock clock;
    for (int i = 0; i < kWaits; ++i, clock.sleep(kWait)) {
      if (::waitpid(m_process, nullptr, WNOHANG) != 0) return;
    }
    ::kill(m_process, SIGKILL);
    ::waitpid(m_process, nullptr, 0);
  }
  ProcessStream(const ProcessStream&) = delete;
  ProcessStream& operator=(const ProcessStream&) = delete;

  std::ptrdiff_t read(std::span<std::uint8_t> into, double timeout) noexcept override {
    return m_stream->read(into, timeout);
  }
  bool write(std::span<const std::uint8_t> bytes) noexcept override { return m_stream->write(bytes); }

 private:
  std::unique_ptr<FileStream> m_stream;
  pid_t m_process;
};

// The set-up that posix_spawn makes in the new process: the socket at its descriptor, no other file open, no signal
// blocked.
class SpawnSetup {
 public:
  explicit SpawnSetup(int descriptor) {
    ::posix_spawn_file_actions_init(&m_files);
    ::posix_spawn_file_actions_adddup2(&m_files, descriptor, kGuardEnd);
    ::posix_spawn_file_actions_addopen(&m_files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_addclosefrom_np(&m_files, kGuardEnd + 1);
    ::posix_spawnattr_init(&m_attributes);
    sigset_t none;
    ::sigemptyset(&none);
    ::posix_spawnattr_setsigmask(&m_attributes, &none);
    ::posix_spawnattr_setflags(&m_attributes, POSIX_SPAWN_SETSID | POSIX_SPAWN_SETSIGMASK);
  }
  ~SpawnSetup() {
    ::posix_spawn_file_actions_destroy(&m_files);
    ::posix_spawnattr_destroy(&m_attributes);
  }
  SpawnSetup(const SpawnSetup&) = delete;
  SpawnSetup& operator=(const SpawnSetup&) = delete;

  int spawn(pid_t& process, const std::string& path, const std::string& address) const {
    std::string program = path, argument = address;
    std::array<char*, 3> words{program.data(), argument.data(), nullptr};
    return ::posix_spawn(&process, path.c_str(), &m_files, &m_attributes, words.data(), environ);
  }

 private:
  posix_spawn_file_actions_t m_files{};
  posix_spawnattr_t m_attributes{};
};

Error notStarted(int reason, const std::string& path) {
  return {DeviceError::Unreachable, {std::strerror(reason)}, {}, path};
}

void stopOnSignals() {
  struct sigaction action {};
  action.sa_handler = [](int) { stopped = true; };
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) ::sigaction(signal, &action, nullptr);
  action.sa_handler = SIG_IGN;
  ::sigaction(SIGPIPE, &action, nullptr);  // for messages to a terminal that is gone
}

}  // namespace

std::string guardPath(const std::string& name) {
  if (const char* const folder = std::getenv("HANDWHEEL_GUARDS")) return std::string(folder) + "/" + name;
  Dl_info module{};
  if (::dladdr(reinterpret_cast<const void*>(&guardPath), &module) == 0 || !module.dli_fname) return name;
  const std::filesystem::path plugin(module.dli_fname);
  return (plugin.parent_path().parent_path() / "guards" / name).string();
}

Result<std::unique_ptr<ByteStream>> startGuard(const std::string& path, const std::string& address) {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) return notStarted(errno, path);
  ::fcntl(ends[0], F_SETFL, O_NONBLOCK);
  pid_t process = 0;
  const int reason = SpawnSetup(ends[1]).spawn(process, path, address);
  ::close(ends[1]);
  if (reason == 0) return std::unique_ptr<ByteStream>(std::make_unique<ProcessStream>(ends[0], process));
  ::close(ends[0]);
  return notStarted(reason, path);
}

std::unique_ptr<Session> guarded(const std::string& path, const std::string& address, const DeviceCapabilities& kind,
                                 const std::string& name) {
  const auto start = [path, address] { return startGuard(path, address); };
  return std::make_unique<OutOfProcessSession>(start, std::make_shared<SteadyClock>(), kind, name);
}

int runDeviceHost(int argc, char** argv,
                  const std::function<std::unique_ptr<Session>(const std::string& address)>& make) {
  int type = 0;
  socklen_t size = sizeof(type);
  if (argc != 2 || ::getsockopt(kGuardEnd, SOL_SOCKET, SO_TYPE, &type, &size) != 0) {
    std::fprintf(stderr, "%s: Handwheel starts this program to hold a device for it.\n", argc > 0 ? argv[0] : "guard");
    return 2;
  }
  stopOnSignals();
  ::fcntl(kGuardEnd, F_SETFL, O_NONBLOCK);
  ::fcntl(kGuardEnd, F_SETFD, FD_CLOEXEC);
  (void)makeThreadRealTime(kGuardPriority);
  FileStream stream(kGuardEnd);
  SteadyClock clock;
  const std::unique_ptr<Session> session = make(argv[1]);
  guard::SessionHost(*session, stream, clock, stopped).serve();
  return 0;
}

}  // namespace handwheel
