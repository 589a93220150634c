// A folder that is written is whole under its final name at all times.

#include "Module/Files/PhantomFiles.h"
#include "Scene/Files/OutputFile.h"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

using namespace varimarch;

namespace
{

void WriteTextInFolder(const std::string& path, const std::string& text)
{
  WriteFolderWhole(
    path, [](const std::string&) { return true; },
    [&](const std::string& part) { std::ofstream(std::filesystem::path(part) / "text") << text; });
}

}

TEST(OutputFolder, IsThereWhileItIsReplaced)
{
  constexpr int Replacements = 30;
  const TemporaryFolder folder;
  const std::string path = folder.Path("volume.zarr");
  WriteTextInFolder(path, "first");
  std::atomic<bool> stop = false;
  std::atomic<int> gaps = 0;
  std::thread reader(
    [&]
    {
      while (!stop)
      {
        gaps += !std::filesystem::exists(path);
      }
    });
  for (int i = 0; i < Replacements; ++i)
  {
    WriteTextInFolder(path, std::to_string(i));
  }
  stop = true;
  reader.join();
  EXPECT_EQ(gaps, 0);
  EXPECT_EQ(folder.Bytes("volume.zarr/text"), std::to_string(Replacements - 1));
  const std::filesystem::directory_iterator files(folder.Path(""));
  EXPECT_EQ(std::distance(files, std::filesystem::directory_iterator()), 1);
}
