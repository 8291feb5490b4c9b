// process_test.cpp: a program runs under its limits, and nothing of it is left behind.
#include "reference/process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace litmus {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using testing::HasSubstr;

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  return (std::stringstream() << in.rdbuf()).str();
}

/// Whether a process exists and is not a zombie that only waits for its parent.
bool alive(pid_t pid) {
  const auto stat = text_of("/proc/" + std::to_string(pid) + "/stat");
  const auto after_name = stat.rfind(')');
  return after_name != std::string::npos && stat.size() > after_name + 2 &&
         stat[after_name + 2] != 'Z';
}

bool dies_within(pid_t pid, std::chrono::milliseconds limit) {
  const auto deadline = std::chrono::steady_clock::now() + limit;
  while (alive(pid)) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    std::this_thread::sleep_for(2ms);
  }
  return true;
}

/// The process number that a script wrote into a file, once it is there.
pid_t pid_in(const fs::path& file) {
  for (int i = 0; i < 2000; ++i) {
    const auto text = text_of(file);
    if (text.ends_with('\n')) return pid_t(std::stol(text));
    std::this_thread::sleep_for(2ms);
  }
  throw std::runtime_error("no process number in " + file.string());
}

struct Process : testing::Test {
  fs::path folder = fs::path(testing::TempDir()) /
                    ("process-" + std::to_string(::getpid()) + "-" +
                     testing::UnitTest::GetInstance()->current_test_info()->name());
  void SetUp() override { fs::create_directories(folder); }
  void TearDown() override { fs::remove_all(folder); }

  Command command(std::vector<std::string> arguments) const {
    Command result;
    result.arguments = std::move(arguments);
    result.directory = folder / "work";
    result.log = folder / "log";
    result.time_limit = 20s;
    return result;
  }
  Command script(const std::string& text) const { return command({"sh", "-c", text}); }
  std::string log() const { return text_of(folder / "log"); }
};

TEST_F(Process, ReportsSuccess) {
  const auto result = run_process(command({"true"}));
  EXPECT_TRUE(result.ok());
  EXPECT_EQ(result.explanation, "true exited with 0");
}

TEST_F(Process, ReportsTheExitCode) {
  const auto result = run_process(script("exit 7"));
  EXPECT_EQ(result.outcome, Outcome::Exited);
  EXPECT_EQ(result.code, 7);
  EXPECT_FALSE(result.ok());
}

TEST_F(Process, ReportsTheSignal) {
  const auto result = run_process(script("kill -SEGV $$"));
  EXPECT_EQ(result.outcome, Outcome::Signalled);
  EXPECT_EQ(result.code, SIGSEGV);
  EXPECT_THAT(result.explanation, HasSubstr("signal 11"));
}

TEST_F(Process, SaysThatAMissingProgramIsMissing) {
  const auto result = run_process(command({"no-such-renderer"}));
  EXPECT_EQ(result.outcome, Outcome::NotStarted);
  EXPECT_EQ(result.explanation, "no-such-renderer did not start: it is not installed");
}

TEST_F(Process, SaysWhyAProgramDoesNotStart) {
  std::ofstream(folder / "broken") << "#!/no/such/interpreter\n";
  fs::permissions(folder / "broken", fs::perms::owner_all);
  const auto result = run_process(command({(folder / "broken").string()}));
  EXPECT_EQ(result.outcome, Outcome::NotStarted);
  EXPECT_THAT(result.explanation, HasSubstr("No such file"));
}

TEST_F(Process, SaysThatTheLogCannotBeWritten) {
  auto it = command({"true"});
  it.log = folder / "missing" / "log";
  EXPECT_EQ(run_process(it).outcome, Outcome::NotStarted);
}

TEST_F(Process, KeepsOutputAndErrorsInOneLog) {
  run_process(script("echo one; echo two >&2; echo three"));
  EXPECT_EQ(log(), "one\ntwo\nthree\n");
}

TEST_F(Process, PassesArgumentsWithoutAShell) {
  run_process(command({"printf", "%s|", "$HOME", "a b", "; echo x", "*", "'"}));
  EXPECT_EQ(log(), "$HOME|a b|; echo x|*|'|");
}

TEST_F(Process, GivesItsOwnHomeAndFolders) {
  run_process(
      script("pwd; echo $HOME; echo $TMPDIR; test -d $TMPDIR && echo \"[$XDG_CONFIG_HOME]\""));
  const auto work = (folder / "work").string();
  EXPECT_EQ(log(), work + "\n" + work + "\n" + work + "/tmp\n[]\n");
}

TEST_F(Process, ReadsNothingFromStandardInput) {
  EXPECT_TRUE(run_process(script("! read line")).ok());
}

TEST_F(Process, InheritsNoOtherDescriptor) {
  const int extra = ::dup(1);  // without close-on-exec
  const auto number = std::to_string(extra);
  const auto result =
      run_process(script("test -e /proc/$$/fd/1 && ! test -e /proc/$$/fd/" + number));
  ::close(extra);
  EXPECT_TRUE(result.ok());
}

TEST_F(Process, StopsWhatTakesTooLongBySigtermFirst) {
  auto it = script("trap 'echo asked; exit 3' TERM; while :; do sleep 0.05; done");
  it.time_limit = 200ms;
  const auto result = run_process(it);
  EXPECT_EQ(result.outcome, Outcome::TimedOut);
  EXPECT_EQ(result.explanation, "sh was stopped after its time limit of 0.2 s");
  EXPECT_THAT(log(), HasSubstr("asked"));
  EXPECT_LT(result.seconds, 1.5);
}

TEST_F(Process, KillsAProgramThatIgnoresSigtermAndItsChild) {
  auto it = script("trap '' TERM; sh -c 'trap \"\" TERM; echo $$ >../child; sleep 60' & sleep 60");
  it.time_limit = 300ms;
  const auto result = run_process(it);
  EXPECT_EQ(result.outcome, Outcome::TimedOut);
  EXPECT_EQ(result.code, SIGKILL);
  EXPECT_GE(result.seconds, 2.3);  // the limit and the 2 s of grace
  EXPECT_LT(result.seconds, 5);
  EXPECT_TRUE(dies_within(pid_in(folder / "child"), 1s));
}

TEST_F(Process, EndsTheChildrenOfAProgramThatEnded) {
  EXPECT_TRUE(run_process(script("sleep 60 & echo $! >../child")).ok());
  EXPECT_TRUE(dies_within(pid_in(folder / "child"), 1s));
}

TEST_F(Process, LeavesNoZombie) {
  run_process(script("exit 0"));
  EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
}

TEST_F(Process, LimitsTheMemory) {
  // Holds 256 MiB of text: more than the first limit allows, less than the second.
  auto it = script("x=$(head -c 268435456 /dev/zero | tr '\\0' x); echo ${#x}");
  it.memory_limit_bytes = std::int64_t{64} << 20;
  EXPECT_FALSE(run_process(it).ok());
  it = script("ulimit -v");
  run_process(it);
  EXPECT_EQ(log(), std::to_string(it.memory_limit_bytes / 1024) + "\n");
}

TEST_F(Process, CallsBackWhileItRuns) {
  auto it = script("sleep 0.5");
  int calls = 0;
  it.while_running = [&] { ++calls; };
  EXPECT_TRUE(run_process(it).ok());
  EXPECT_GE(calls, 2);
}

TEST_F(Process, EndsTheProgramWhenTheCallBackThrows) {
  auto it = script("echo $$ >../child; sleep 60");
  it.while_running = [] { throw std::runtime_error("enough"); };
  EXPECT_THROW(run_process(it), std::runtime_error);
  EXPECT_TRUE(dies_within(pid_in(folder / "child"), 1s));
}

/// Runs the command in a process of its own, as litmus would, and gives its number.
pid_t in_another_process(const Command& command) {
  const pid_t pid = ::fork();
  if (pid == 0) {
    end_processes_on_interrupt();
    run_process(command);
    ::_exit(0);
  }
  return pid;
}

int ending_of(pid_t pid) {
  int status = 0;
  ::waitpid(pid, &status, 0);
  return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

TEST_F(Process, DiesWithAKilledLitmus) {
  const pid_t litmus = in_another_process(script("echo $$ >../child; exec sleep 60"));
  const pid_t renderer = pid_in(folder / "child");
  ASSERT_TRUE(alive(renderer));
  ::kill(litmus, SIGKILL);
  EXPECT_EQ(ending_of(litmus), SIGKILL);
  EXPECT_TRUE(dies_within(renderer, 1s));
}

TEST_F(Process, DiesWithItsChildrenOnAnInterrupt) {
  const pid_t litmus = in_another_process(script("sleep 60 & echo $! >../child; wait"));
  const pid_t grandchild = pid_in(folder / "child");
  ASSERT_TRUE(alive(grandchild));
  ::kill(litmus, SIGINT);
  EXPECT_EQ(ending_of(litmus), SIGINT);
  EXPECT_TRUE(dies_within(grandchild, 1s));
}

TEST_F(Process, RunsFromSeveralThreads) {
  std::vector<ProcessResult> results(8);
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i)
    threads.emplace_back([&, i] {
      auto it = script("exit " + std::to_string(i));
      it.log = folder / ("log" + std::to_string(i));
      results[std::size_t(i)] = run_process(it);
    });
  for (auto& thread : threads) thread.join();
  for (int i = 0; i < 8; ++i) EXPECT_EQ(results[std::size_t(i)].code, i);
}

TEST_F(Process, TailGivesTheLastLines) {
  std::ofstream(folder / "log") << "a\nb\nc\rd\n\n";
  EXPECT_EQ(tail(folder / "log", 2), "c\nd");
  EXPECT_EQ(tail(folder / "log", 9), "a\nb\nc\nd");
  EXPECT_EQ(tail(folder / "missing"), "");
}

TEST_F(Process, FindsAProgramOnThePath) {
  EXPECT_EQ(find_program("sh").filename(), "sh");
  EXPECT_TRUE(find_program("no-such-renderer").empty());
  EXPECT_TRUE(find_program("/etc/passwd").empty());
}

}  // namespace
}  // namespace litmus
