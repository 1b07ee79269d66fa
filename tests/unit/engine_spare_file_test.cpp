#include "engine/spare_file.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/atomic_file.h"
#include "base/error.h"
#include "support/scratch_folder.h"

namespace calotype {
namespace {

using test::readBytes;
using test::ScratchFolder;
namespace fs = std::filesystem;

/// Writes "the film" wherever it is told to.
void writeFilmText(const fs::path& path) { writeFileAtomically(path, "the film"); }

std::string messageOf(SpareFile& file) {
    try {
        file.write("the film", writeFilmText);
    } catch (const OutputError& error) {
        return error.what();
    }
    return "";
}

/// The file that the message names.
fs::path keptIn(const std::string& message) {
    const std::string before = "; the film is kept in '";
    const size_t at = message.find(before);
    if (at == std::string::npos)
        return {};
    const size_t start = at + before.size();
    return message.substr(start, message.find('\'', start) - start);
}

TEST(SpareFileTest, WritesTheFileItselfWhereItCan) {
    const ScratchFolder folder;
    SpareFile file(folder / "a.film", {folder / "no such folder"});
    EXPECT_EQ(messageOf(file), "");
    EXPECT_EQ(readBytes(folder / "a.film"), "the film");
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(SpareFileTest, KeepsTheResultInTheFirstFolderThatTakesIt) {
    const ScratchFolder folder;
    fs::create_directories(folder / "full/a.film"); // a folder, so that no file is written there
    fs::create_directory(folder / "good");
    fs::create_directory(folder / "later");
    SpareFile file(folder / "full/a.film",
                   {folder / "full", folder / "none", folder / "good", folder / "later"});
    const std::string message = messageOf(file);
    EXPECT_NE(message.find("full/a.film'"), std::string::npos) << message;
    const fs::path kept = keptIn(message);
    EXPECT_EQ(kept.parent_path(), folder / "good") << message;
    EXPECT_EQ(kept.extension(), ".film");
    EXPECT_EQ(readBytes(kept), "the film");
    EXPECT_TRUE(fs::is_empty(folder / "later"));
    EXPECT_TRUE(message.ends_with("; when there is room: mv " + kept.string() + " " +
                                  (folder / "full/a.film").string()))
        << message;
    // The next time it is replaced, and removed once the result has its own place.
    EXPECT_EQ(keptIn(messageOf(file)), kept);
    fs::remove(folder / "full/a.film");
    EXPECT_EQ(messageOf(file), "");
    EXPECT_TRUE(fs::is_empty(folder / "good"));
    EXPECT_EQ(readBytes(folder / "full/a.film"), "the film");
}

TEST(SpareFileTest, TakesTheTemporaryFolderLastAndReplacesNothing) {
    const ScratchFolder folder;
    const fs::path first = keptIn([&] {
        SpareFile file(folder / "none/a.film", {});
        return messageOf(file);
    }());
    SpareFile file(folder / "none/a.film", {});
    const fs::path second = keptIn(messageOf(file));
    EXPECT_EQ(first.parent_path(), fs::temp_directory_path());
    EXPECT_EQ(second.parent_path(), fs::temp_directory_path());
    EXPECT_NE(first, second);
    for (const fs::path& path : {first, second}) {
        EXPECT_EQ(readBytes(path), "the film");
        fs::remove(path);
    }
}

TEST(SpareFileTest, FoldersOfFilesAreEachOnce) {
    EXPECT_EQ(foldersOf({"a.png", "x/a.png", "", "x/b.film", "b.png"}),
              (std::vector<fs::path>{".", "x"}));
}

} // namespace
} // namespace calotype
