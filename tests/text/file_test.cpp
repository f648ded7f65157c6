#include "percal/text/file.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>

#include "percal/base/error.hpp"
#include "percal/base/inputs.hpp"
#include "support/temporary_folder.hpp"

namespace percal {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class File : public testing::Test, protected test::TemporaryFolder {
 protected:
  std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (const auto& entry : fs::directory_iterator(folder)) result.push_back(entry.path().filename().string());
    return result;
  }
};

// Files beyond `bytes` cannot be written while this lives: the disk is full.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int);
};

TEST_F(File, WhatIsWrittenIsReadBackByteForByte) {
  const std::string content = std::string("a\r\nb\0c\xff", 7) + std::string(300000, 'x');
  write_file(path("new/deep/file.txt"), content);
  EXPECT_EQ(read_file(path("new/deep/file.txt")), content);
  write_file(path("new/deep/file.txt"), "short");
  EXPECT_EQ(read_file(path("new/deep/file.txt")), "short");
}

TEST_F(File, AFullDiskLeavesTheOldFileAndNothingElse) {
  write_file(path("result.json"), "old");
  {
    const FullDisk full(1000);
    EXPECT_THROW(write_file(path("result.json"), std::string(5000, 'x')), IoFailure);
    EXPECT_THROW(write_file(path("other.json"), std::string(5000, 'x')), IoFailure);
    EXPECT_THROW(ensure_writable_folder(folder.string()), IoFailure);
  }
  EXPECT_EQ(read_file(path("result.json")), "old");
  EXPECT_THAT(names(), testing::ElementsAre("result.json"));
}

TEST_F(File, APipeIsWrittenToAndNotReplaced) {
  const std::string pipe = path("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  EXPECT_NO_THROW(write_file(pipe, "text"));
  char received[8] = "";
  EXPECT_EQ(read(reader, received, sizeof received), 4);
  EXPECT_STREQ(received, "text");
  close(reader);
  EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST_F(File, AnUnwritableFolderIsAnIoFailureThatNamesThePath) {
  write_file(path("regular"), "");
  for (const std::string& path : {path("regular/below"), std::string("/proc/percal/file")}) {
    try {
      write_file(path, "text");
      ADD_FAILURE() << path;
    } catch (const IoFailure& error) {
      EXPECT_THAT(error.what(), HasSubstr(fs::path(path).parent_path().string()));
    }
    EXPECT_THROW(ensure_writable_folder(path), IoFailure);
  }
  EXPECT_THROW(write_file(folder.string(), "text"), IoFailure);
  EXPECT_THROW(write_file("", "text"), IoFailure);
  EXPECT_THROW(ensure_writable_folder(path("regular")), IoFailure);
}

TEST_F(File, WhatKilledProcessesHaveLeftIsTidiedAndNothingOfThoseThatLive) {
  fs::create_directories(path("a"));
  const std::string dead = path("a/.percal-1-0.tmp"), living = path("a/.percal-2-0.tmp"), other = path("a/notes.tmp");
  for (const std::string& file : {dead, living, other}) std::ofstream(file) << "half of it";
  const int locked = open(living.c_str(), O_RDWR);
  ASSERT_EQ(flock(locked, LOCK_EX), 0);
  write_file(path("a/result.json"), "text");
  EXPECT_FALSE(fs::exists(dead));
  EXPECT_TRUE(fs::exists(living));
  EXPECT_TRUE(fs::exists(other));
  close(locked);
}

TEST_F(File, ALeftoverOfAProcessOfTheSameNumberIsInNobodysWay) {
  const pid_t child = fork();  // whose first names would be these
  if (child == 0) {
    const std::string own = ".percal-" + std::to_string(getpid()) + "-";
    for (int k = 0; k < 20; ++k) {
      std::ofstream(path(own + std::to_string(k) + ".tmp")) << "x";
      chmod(path(own + std::to_string(k) + ".tmp").c_str(), 0);
    }
    try {
      write_file(path("result.json"), "text");
    } catch (const std::exception&) {
      _exit(1);
    }
    _exit(0);
  }
  int status = 1;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(read_file(path("result.json")), "text");
}

TEST_F(File, AnInputIsNotReplacedWhileInputsAreKept) {
  write_file(path("in"), "in");
  fs::create_hard_link(path("in"), path("hard"));
  fs::create_symlink("in", path("soft"));
  {
    const InputsAreKept kept;
    read_output(path("in"));
    EXPECT_NO_THROW(write_file(path("in"), "in")) << "looked at, not read";
    fs::remove(path("hard"));
    fs::create_hard_link(path("in"), path("hard"));
    read_file(path("in"));
    for (const char* name : {"in", "hard", "soft"}) {
      EXPECT_THROW(write_file(path(name), "out"), BadInput) << name;
      EXPECT_THROW(ensure_writable_file(path(name)), BadInput) << name;
    }
    write_file(path("out"), "out");
  }
  EXPECT_EQ(read_file(path("in")), "in");
  EXPECT_NO_THROW(write_file(path("in"), "out")) << "a program that uses the library may";
}

TEST_F(File, AWritableFolderIsLeftEmpty) {
  ensure_writable_folder(path("a/b"));
  EXPECT_TRUE(fs::is_directory(path("a/b")));
  EXPECT_TRUE(fs::is_empty(path("a/b")));
}

TEST_F(File, ALinkStaysALinkAndPermissionsStay) {
  write_file(path("real"), "old");
  chmod(path("real").c_str(), 0640);
  fs::create_symlink("real", path("link"));
  write_file(path("link"), "new");
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(read_file(path("real")), "new");
  struct stat status;
  ASSERT_EQ(stat(path("real").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 07777, 0640u);
}

TEST_F(File, AMissingFileOrAFolderIsBadInput) {
  EXPECT_THROW(read_file(path("missing")), BadInput);
  EXPECT_THROW(read_file(folder.string()), BadInput);
  EXPECT_THROW(read_file(""), BadInput);
  EXPECT_THROW(read_file(std::string(5000, 'x')), BadInput);
}

}  // namespace
}  // namespace percal
