#include "renderer/io/file.h"

#include <csignal>
#include <sys/resource.h>
#include <sys/stat.h>
#include <thread>
#include <vector>

#include "renderer/io/printable.h"
#include "tests/io/scratch.h"

namespace kd {
namespace {

namespace fs = std::filesystem;

TEST(File, WritesAndReadsBackEveryByte) {
    const fs::path path = scratch_folder() / "bytes";
    std::string bytes;
    for (int i = 0; i < 3'000'000; ++i) bytes += static_cast<char>(i * 31 >> 3);
    write_file(path, bytes);
    EXPECT_EQ(read_file(path), bytes);
    write_file(path, "");
    EXPECT_EQ(read_file(path), "");
    EXPECT_EQ(count_files(path.parent_path()), 1) << "a temporary file was left behind";
}

TEST(File, NewFileHasTheUsualPermissions) {
    const fs::path path = scratch_folder() / "file";
    const mode_t mask = ::umask(022);
    write_file(path, "x");
    ::umask(mask);
    EXPECT_EQ(fs::status(path).permissions(), fs::perms(0644));
}

TEST(File, WritesBesideWithoutAFolderInTheName) {
    const fs::path folder = scratch_folder();
    const fs::path before = fs::current_path();
    fs::current_path(folder);
    write_file("plain.txt", "hello");
    fs::current_path(before);
    EXPECT_EQ(get_bytes(folder / "plain.txt"), "hello");
}

TEST(File, FailedWriteLeavesNothingAndKeepsTheOldFile) {
    const fs::path folder = scratch_folder();
    EXPECT_TRUE(holds(error_of([&] { write_file(folder, "x"); }), "it is a directory"));
    const std::string error = error_of([&] { write_file(folder / "none" / "x.png", "x"); });
    EXPECT_TRUE(holds(error, "x.png: there is no folder"));
    EXPECT_TRUE(holds(error_of([&] { write_file("", "x"); }), "without a name"));
    EXPECT_EQ(count_files(folder), 0);

    // The name is too long to be renamed to, so the temporary file exists before the failure.
    const std::string long_name(300, 'n');
    EXPECT_TRUE(holds(error_of([&] { write_file(folder / long_name, "x"); }), "too long"));
    EXPECT_EQ(count_files(folder), 0);
}

TEST(File, AFullDiskKeepsTheOldFileAndLeavesNothing) {
    const fs::path path = scratch_folder() / "file";
    write_file(path, "old");
    // A limit on the size of files fails in the middle of writing, as a full disk does.
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{1000, before.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    const std::string error = error_of([&] { write_file(path, std::string(100'000, 'x')); });
    ::setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    EXPECT_TRUE(holds(error, "cannot write " + path.string() + ": File too large"));
    EXPECT_EQ(get_bytes(path), "old");
    EXPECT_EQ(count_files(path.parent_path()), 1);
}

TEST(File, LeavesASymbolicLinkInPlace) {
    const fs::path folder = scratch_folder();
    fs::create_directory(folder / "real");
    put_bytes(folder / "real" / "file", "old");
    fs::create_symlink("real/file", folder / "link");
    write_file(folder / "link", "new");
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(get_bytes(folder / "real" / "file"), "new");
}

TEST(File, WritesIntoAPipe) {
    const fs::path pipe = scratch_folder() / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    std::string got;
    std::thread reader([&] { got = read_file(pipe); });
    write_file(pipe, "through");
    reader.join();
    EXPECT_EQ(got, "through");
    EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST(File, ThreadsDoNotDisturbEachOther) {
    const fs::path folder = scratch_folder();
    const std::string a(100'000, 'a');
    const std::string b(100'000, 'b');
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i) {
        threads.emplace_back([&, i] {
            for (int k = 0; k < 20; ++k) write_file(folder / "same", i % 2 == 0 ? a : b);
        });
    }
    for (std::thread& thread : threads) thread.join();
    const std::string got = get_bytes(folder / "same");
    EXPECT_TRUE(got == a || got == b) << "mixed contents";
    EXPECT_EQ(count_files(folder), 1);
}

TEST(File, ReadingNamesPathAndReason) {
    const fs::path folder = scratch_folder();
    EXPECT_EQ(error_of([&] { (void)read_file(folder); }), "cannot read " + folder.string() + ": it is a directory");
    const fs::path none = folder / "x.gltf";
    EXPECT_EQ(error_of([&] { (void)read_file(none); }), "cannot read " + none.string() + ": it does not exist");
    put_bytes(folder / "ten", "0123456789");
    EXPECT_EQ(read_file(folder / "ten", 10), "0123456789");
    EXPECT_TRUE(holds(error_of([&] { (void)read_file(folder / "ten", 9); }), "larger than the limit of 9 bytes"));
    EXPECT_TRUE(holds(error_of([&] { (void)read_file("/dev/zero", 5'000'000); }), "larger than the limit"));
}

TEST(Printable, KeepsOneHarmlessLine) {
    EXPECT_EQ(printable("plain text"), "plain text");
    EXPECT_EQ(printable("a\nb\tc\x1b[31m\x7f"), "a?b?c?[31m?");
    EXPECT_EQ(printable("b\xc2\x9b"
                        "31m"),
              "b?31m");  // the one-character form of escape [
    EXPECT_EQ(printable("Gr\xc3\xbc\xc3\x9f"
                        "e"),
              "Gr\xc3\xbc\xc3\x9f"
              "e");
    EXPECT_EQ(printable("123456789", 4), "1234...");
    EXPECT_EQ(printable("123\xc3\xbc", 4), "123...") << "a character must not be cut in half";
}

}  // namespace
}  // namespace kd
