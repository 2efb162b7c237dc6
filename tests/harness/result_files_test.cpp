// SPDX-License-Identifier: GPL-3.0-or-later
// CSV and sidecar on the disk.
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "files/file_bytes.hpp"
#include "harness/provenance.hpp"
#include "support/temporary_folder.hpp"
#include "support/thrown.hpp"

namespace impinge::lab {
namespace {

using test::TemporaryFolder;

namespace fs = std::filesystem;

std::size_t files_in(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

// A moment that no file written by the test can have by itself.
const auto kLongAgo = fs::file_time_type::clock::now() - std::chrono::hours(1000);

Result small_result(double value) {
  Result result;
  result.name = "numbers";
  result.question = "Which number?";
  result.table.columns = {{"value", "mm", "a length"}};
  result.table.add_row({value});
  result.parameters = {{"step", 0.5}};
  return result;
}

RunRecord record_in(const fs::path& folder) {
  RunRecord record{"driver", "driver --seed 7", "quick", 7, folder};
  return record;
}

TEST(Digest, KnownAnswersOfFips180) {
  EXPECT_EQ(sha256_hex(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256_hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(AtomicFile, ReplacesTheBytesAndLeavesNothingElse) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "a.csv";
  EXPECT_TRUE(write_if_changed(file, "one\n"));
  EXPECT_TRUE(write_if_changed(file, "two\n"));
  EXPECT_EQ(read_bytes(file), "two\n");
  EXPECT_EQ(files_in(folder.path()), 1U);
}

TEST(AtomicFile, SameBytesKeepTheTimeStamp) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "a.csv";
  write_if_changed(file, "one\n");
  fs::last_write_time(file, kLongAgo);
  const auto before = fs::last_write_time(file);
  EXPECT_FALSE(write_if_changed(file, "one\n"));
  EXPECT_EQ(fs::last_write_time(file), before);
  EXPECT_TRUE(write_if_changed(file, "one\n "));
  EXPECT_NE(fs::last_write_time(file), before);
}

TEST(AtomicFile, SaysWhichPathCannotBeWritten) {
  const TemporaryFolder folder;
  write_if_changed(folder.path() / "plain", "a file");
  const std::string said =
      test::thrown<std::runtime_error>([&] { write_if_changed(folder.path() / "plain" / "a.csv", "x"); });
  EXPECT_NE(said.find("plain/a.csv"), std::string::npos) << said;
  EXPECT_THROW(require_writable_folder(folder.path() / "plain"), std::runtime_error);
  EXPECT_THROW(read_bytes(folder.path() / "missing"), std::runtime_error);
  require_writable_folder(folder.path() / "new" / "folder");
  EXPECT_EQ(files_in(folder.path() / "new" / "folder"), 0U);
}

TEST(Provenance, SidecarSaysHowTheCsvCameToBe) {
  const TemporaryFolder folder;
  write_result(record_in(folder.path()), small_result(1.5));
  EXPECT_EQ(read_bytes(folder.path() / "numbers.csv"), "value\n1.5\n");
  const auto record = nlohmann::json::parse(read_bytes(folder.path() / "numbers.json"));
  EXPECT_EQ(record["csv_sha256"], sha256_hex("value\n1.5\n"));
  EXPECT_EQ(record["driver_sha256"], sha256_of_file("/proc/self/exe"));
  EXPECT_EQ(record["columns"][0]["unit"], "mm");
  EXPECT_EQ(record["parameters"]["step"], 0.5);
  EXPECT_EQ(record["seed"], 7);
  EXPECT_EQ(record["profile"], "quick");
  EXPECT_NE(record["flags"].get<std::string>().find("-ffp-contract=off"), std::string::npos);
  EXPECT_TRUE(record["libraries"].contains("Eigen3"));
  EXPECT_GT(record["cores"], 0);
  EXPECT_GT(record["memory_mib"], 0);
  for (const char* key :
       {"question", "commit", "dirty", "compiler", "cpu", "started_utc", "duration_s", "command"}) {
    EXPECT_TRUE(record.contains(key)) << key;
  }
}

TEST(Provenance, SameResultAgainTouchesNothing) {
  const TemporaryFolder folder;
  write_result(record_in(folder.path()), small_result(1.5));
  fs::last_write_time(folder.path() / "numbers.csv", kLongAgo);
  fs::last_write_time(folder.path() / "numbers.json", kLongAgo);
  const auto before = fs::last_write_time(folder.path() / "numbers.json");
  write_result(record_in(folder.path()), small_result(1.5));
  EXPECT_EQ(fs::last_write_time(folder.path() / "numbers.csv"), before);
  EXPECT_EQ(fs::last_write_time(folder.path() / "numbers.json"), before);
  write_result(record_in(folder.path()), small_result(2.5));
  EXPECT_NE(fs::last_write_time(folder.path() / "numbers.csv"), before);
  EXPECT_NE(fs::last_write_time(folder.path() / "numbers.json"), before);
}

TEST(Provenance, ASidecarThatDoesNotFitIsReplaced) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "numbers.json";
  for (const char* wrong : {"", "not json", "[]", "{\"csv_sha256\": 3}"}) {
    write_result(record_in(folder.path()), small_result(1.5));
    std::ofstream(file) << wrong;
    write_result(record_in(folder.path()), small_result(1.5));
    EXPECT_EQ(nlohmann::json::parse(read_bytes(file))["csv_sha256"], sha256_hex("value\n1.5\n")) << wrong;
  }
}

TEST(Provenance, CommitComesFromTheEnvironmentWhenItIsThere) {
  ::setenv("IMPINGE_COMMIT", "0123abcd", 1);
  ::setenv("IMPINGE_DIRTY", "1", 1);
  const auto record = sidecar(record_in("."), small_result(1.0), "");
  ::unsetenv("IMPINGE_COMMIT");
  ::unsetenv("IMPINGE_DIRTY");
  EXPECT_EQ(record["commit"], "0123abcd");
  EXPECT_EQ(record["dirty"], true);
}

using test::TemporaryFolder;

int git_in(const std::filesystem::path& folder, const std::string& arguments) {
  return std::system(("git -C '" + folder.string() + "' " + arguments + " >/dev/null 2>&1").c_str());
}

TEST(SourceState, IsUnknownOutsideOfARepository) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / ".git") << "not a repository";  // stops the search in the folders above
  const SourceState state = source_state(folder.path());
  EXPECT_EQ(state.commit, "unknown");
  EXPECT_FALSE(state.dirty.has_value());
}

// A repository with one file, "kept", committed.
void commit_one_file(const std::filesystem::path& folder) {
  ASSERT_EQ(git_in(folder, "init"), 0);
  std::ofstream(folder / "kept") << "as committed";
  std::ofstream(folder / ".gitignore") << "*.tmp\n";
  ASSERT_EQ(git_in(folder, "add kept .gitignore"), 0);
  ASSERT_EQ(git_in(folder, "-c user.name=t -c user.email=t@t commit -m first"), 0);
}

TEST(SourceState, TellsACleanTreeFromAChangedOne) {
  const TemporaryFolder folder;
  commit_one_file(folder.path());
  const SourceState clean = source_state(folder.path());
  EXPECT_EQ(clean.commit.size(), 40U);
  EXPECT_EQ(clean.dirty, false);
  std::ofstream(folder.path() / "kept") << "changed";
  EXPECT_EQ(source_state(folder.path()).dirty, true);
  EXPECT_EQ(source_state(folder.path()).commit, clean.commit);
}

TEST(SourceState, CountsNewFilesWhereResultsComeFrom) {
  for (const char* name : {"libcore", "experiments", "analysis", "paper"}) {
    const TemporaryFolder folder;
    commit_one_file(folder.path());
    std::filesystem::create_directories(folder.path() / name / "inner");
    std::ofstream(folder.path() / name / "inner" / "ignored.tmp") << "x";
    std::ofstream(folder.path() / "note.txt") << "x";
    EXPECT_EQ(source_state(folder.path()).dirty, false) << name;
    std::ofstream(folder.path() / name / "inner" / "new file.cpp") << "x";
    EXPECT_EQ(source_state(folder.path()).dirty, true) << name;
  }
}

}  // namespace
}  // namespace impinge::lab
