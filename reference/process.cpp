// process.cpp: start, limits, and the certain end of a whole process group.
#include "reference/process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string_view>
#include <thread>

extern char** environ;

namespace litmus {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto kGrace = 2s;         // between SIGTERM and SIGKILL
constexpr auto kPoll = 5ms;         // short beside the 650 ms of the fastest renderer's start
constexpr auto kFollowing = 100ms;  // between calls of Command::while_running

/// The running groups' leaders, for the signal handler: it may touch nothing but lock-free atomics.
std::array<std::atomic<pid_t>, 64> running_groups;
static_assert(std::atomic<pid_t>::is_always_lock_free);

void remember(pid_t group) {
  for (auto& slot : running_groups) {
    pid_t none = 0;
    if (slot.compare_exchange_strong(none, group)) return;
  }
}

void forget(pid_t group) {
  for (auto& slot : running_groups) {
    pid_t it = group;
    if (slot.compare_exchange_strong(it, 0)) return;
  }
}

extern "C" void end_groups_and_die(int signal) {
  for (auto& slot : running_groups)
    if (const pid_t group = slot.load(); group > 0) ::kill(-group, SIGKILL);
  ::signal(signal, SIG_DFL);
  ::raise(signal);
}

/// A descriptor that closes itself.
struct Descriptor {
  int value = -1;
  explicit Descriptor(int value) : value(value) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(); }
  void close() {
    if (value >= 0) ::close(value);
    value = -1;
  }
};

/// A started group. It is ended and reaped when this goes, however that happens.
struct Group {
  pid_t leader = -1;
  bool reaped = false;

  explicit Group(pid_t leader) : leader(leader) { remember(leader); }
  Group(const Group&) = delete;
  Group& operator=(const Group&) = delete;
  ~Group() {
    if (!reaped) end();
  }

  /// Whether the leader has ended. It stays a zombie, so that its number still names the group.
  bool ended() const {
    siginfo_t info{};
    return ::waitid(P_PID, id_t(leader), &info, WEXITED | WNOHANG | WNOWAIT) != 0 ||
           info.si_pid != 0;
  }

  /// Kills whatever is left of the group, reaps the leader and returns its wait status.
  int end() {
    ::kill(-leader, SIGKILL);
    forget(leader);
    int status = 0;
    while (::waitpid(leader, &status, 0) < 0 && errno == EINTR) {
    }
    reaped = true;
    return status;
  }
};

std::vector<std::string> child_environment(const fs::path& directory) {
  std::vector<std::string> result;
  for (char** entry = environ; *entry; ++entry) {
    const std::string_view text = *entry;
    const auto name = text.substr(0, text.find('='));
    if (name == "HOME" || name == "PWD" || name == "TMPDIR" || name == "LANG" ||
        name == "LANGUAGE" || name.starts_with("LC_") || name.starts_with("XDG_"))
      continue;
    result.emplace_back(text);
  }
  result.push_back("HOME=" + directory.string());
  result.push_back("PWD=" + directory.string());
  result.push_back("TMPDIR=" + (directory / "tmp").string());
  result.push_back("LC_ALL=C.UTF-8");
  return result;
}

std::vector<char*> pointers(std::vector<std::string>& strings) {
  std::vector<char*> result;
  for (auto& text : strings) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

/// All that the child needs, made before it: until exec it lives in the memory of litmus, where
/// only system calls are allowed.
struct Prepared {
  fs::path program, directory;
  std::vector<std::string> arguments, environment;
  std::vector<char*> argv, envp;
  rlim_t memory = 0;
  pid_t parent = 0;
  int input = -1, log = -1, complaint = -1;
};

/// Runs in the child and never returns. A failure before the program starts goes to `complaint`.
[[noreturn]] void become(const Prepared& to) {
  ::setpgid(0, 0);

  // Die with litmus, also if it died before this line.
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != to.parent) ::_exit(127);

  // Forget the signal set-up of litmus.
  struct sigaction usual {};
  usual.sa_handler = SIG_DFL;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGQUIT, SIGCHLD})
    ::sigaction(signal, &usual, nullptr);
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);

  // Keep three descriptors; close-on-exec takes the rest, so that the complaint lives until exec.
  ::dup2(to.input, 0);
  ::dup2(to.log, 1);
  ::dup2(to.log, 2);
  if (::close_range(3, ~0U, CLOSE_RANGE_CLOEXEC) != 0)
    for (int fd = 3; fd < int(::sysconf(_SC_OPEN_MAX)); ++fd) ::fcntl(fd, F_SETFD, FD_CLOEXEC);

  // Limit the memory, leave no core, and go.
  const rlimit memory{to.memory, to.memory}, core{0, 0};
  ::setrlimit(RLIMIT_CORE, &core);
  if (::chdir(to.directory.c_str()) == 0 && ::setrlimit(RLIMIT_AS, &memory) == 0)
    ::execve(to.program.c_str(), to.argv.data(), to.envp.data());
  const int error = errno;
  if (::write(to.complaint, &error, sizeof error) < 0) ::_exit(126);
  ::_exit(127);
}

/// Starts with all signals blocked, so that no handler of litmus ever runs in the child. vfork: a
/// fork would mark all pages of litmus for copying, and a tenth of the CPU time of a live run went
/// into that.
pid_t start(const Prepared& prepared) {
  sigset_t all, before;
  ::sigfillset(&all);
  ::pthread_sigmask(SIG_SETMASK, &all, &before);
  const pid_t child = ::vfork();
  if (child == 0) become(prepared);
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return child;
}

/// Waits for the leader until `deadline`; false if it still runs then.
bool wait_until(const Group& group, Clock::time_point deadline,
                const std::function<void()>& follow) {
  auto next = Clock::now() + kFollowing;
  while (!group.ended()) {
    const auto now = Clock::now();
    if (now >= deadline) return false;
    if (follow && now >= next) {
      follow();
      next = Clock::now() + kFollowing;
    }
    std::this_thread::sleep_for(kPoll);
  }
  return true;
}

ProcessResult not_started(const std::string& program, const std::string& why) {
  return {Outcome::NotStarted, 0, 0, fmt::format("{} did not start: {}", program, why)};
}

ProcessResult explain(const std::string& program, const Command& command, bool timed_out,
                      int status, double seconds) {
  ProcessResult result;
  result.seconds = seconds;
  if (timed_out) {
    const std::chrono::duration<double> limit = command.time_limit;
    result.outcome = Outcome::TimedOut;
    result.code = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
    result.explanation =
        fmt::format("{} was stopped after its time limit of {} s", program, limit.count());
  } else if (WIFSIGNALED(status)) {
    result.outcome = Outcome::Signalled;
    result.code = WTERMSIG(status);
    result.explanation = fmt::format("{} was ended by signal {} ({})", program, result.code,
                                     ::strsignal(result.code));
  } else {
    result.outcome = Outcome::Exited;
    result.code = WEXITSTATUS(status);
    result.explanation = fmt::format("{} exited with {}", program, result.code);
  }
  return result;
}

}  // namespace

ProcessResult run_process(const Command& command) {
  if (command.arguments.empty()) throw std::invalid_argument("run_process: no program is named");
  const auto name = fs::path(command.arguments[0]).filename().string();

  // Prepare everything that may allocate.
  Prepared prepared;
  std::error_code error;
  prepared.program = find_program(command.arguments[0]);
  if (prepared.program.empty()) return not_started(name, "it is not installed");
  prepared.directory = fs::absolute(command.directory, error);
  fs::create_directories(prepared.directory / "tmp", error);
  if (error) return not_started(name, "cannot make " + prepared.directory.string());
  prepared.arguments = command.arguments;
  prepared.environment = child_environment(prepared.directory);
  prepared.argv = pointers(prepared.arguments);
  prepared.envp = pointers(prepared.environment);
  prepared.memory = rlim_t(command.memory_limit_bytes);
  prepared.parent = ::getpid();
  const Descriptor input(::open("/dev/null", O_RDONLY | O_CLOEXEC));
  const Descriptor log(::open(command.log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644));
  if (log.value < 0) return not_started(name, "cannot write its log " + command.log.string());
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) return not_started(name, std::strerror(errno));
  const Descriptor reading(ends[0]);
  Descriptor writing(ends[1]);
  prepared.input = input.value;
  prepared.log = log.value;
  prepared.complaint = writing.value;

  // Start it, and learn whether exec succeeded: then the pipe closes without a word.
  const auto started = Clock::now();
  const pid_t child = start(prepared);
  if (child < 0) return not_started(name, std::strerror(errno));
  Group group(child);
  writing.close();
  int complaint = 0;
  ssize_t got = 0;
  while ((got = ::read(reading.value, &complaint, sizeof complaint)) < 0 && errno == EINTR) {
  }
  if (got == sizeof complaint) return not_started(name, std::strerror(complaint));

  // Wait, stop it where it takes too long, and end what is left of its group.
  const bool in_time = wait_until(group, started + command.time_limit, command.while_running);
  if (!in_time) {
    ::kill(-child, SIGTERM);
    wait_until(group, Clock::now() + kGrace, {});
  }
  const int status = group.end();
  const std::chrono::duration<double> taken = Clock::now() - started;
  return explain(name, command, !in_time, status, taken.count());
}

void end_processes_on_interrupt() {
  struct sigaction action {};
  action.sa_handler = end_groups_and_die;
  ::sigfillset(&action.sa_mask);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before {};
    // A signal that was ignored from outside (nohup) stays so.
    if (::sigaction(signal, nullptr, &before) == 0 && before.sa_handler == SIG_IGN) continue;
    ::sigaction(signal, &action, nullptr);
  }
}

std::string tail(const fs::path& log, int lines) {
  constexpr std::streamoff kMost = 64 << 10;  // enough for any message, whatever the log's size
  std::ifstream file(log, std::ios::binary | std::ios::ate);
  if (!file) return {};
  const std::streamoff size = file.tellg();
  std::string text(std::size_t(std::min(size, kMost)), '\0');
  file.seekg(size - std::streamoff(text.size()));
  file.read(text.data(), std::streamsize(text.size()));
  text.resize(std::size_t(std::max<std::streamsize>(file.gcount(), 0)));
  std::replace(text.begin(), text.end(), '\r', '\n');
  while (!text.empty() && text.back() == '\n') text.pop_back();
  auto begin = text.size();
  for (int line = 0; line < lines && begin != std::string::npos && begin > 0; ++line)
    begin = text.rfind('\n', begin - 1);
  if (lines <= 0) return {};
  return begin == std::string::npos || begin == 0 ? text : text.substr(begin + 1);
}

fs::path find_program(const std::string& name) {
  const auto runnable = [](const fs::path& path) {
    std::error_code error;
    return fs::is_regular_file(path, error) && ::access(path.c_str(), X_OK) == 0;
  };
  if (name.find('/') != std::string::npos) return runnable(name) ? fs::absolute(name) : fs::path{};
  const char* path = std::getenv("PATH");
  std::string_view rest = path ? path : "/usr/local/bin:/usr/bin:/bin";
  while (!name.empty() && !rest.empty()) {
    const auto colon = rest.find(':');
    const auto folder = rest.substr(0, colon);
    if (!folder.empty() && runnable(fs::path(folder) / name))
      return fs::absolute(fs::path(folder) / name);
    rest = colon == std::string_view::npos ? std::string_view{} : rest.substr(colon + 1);
  }
  return {};
}

}  // namespace litmus
