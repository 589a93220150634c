// Writes each target's seeds to FOLDER/TARGET, and its dictionary to FOLDER/TARGET.dict; prints the
// names of the targets.
#include "Fuzz/FuzzTarget.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace
{

/// A word of a dictionary, as libFuzzer reads it.
std::string Quoted(const std::string& word)
{
  std::string quoted = "\"";
  for (const unsigned char byte : word)
  {
    char text[5];
    std::snprintf(text, sizeof(text), "\\x%02x", byte);
    quoted += text;
  }
  return quoted + "\"\n";
}

void Write(const varimarch::FuzzTarget& target, const std::filesystem::path& folder)
{
  std::filesystem::create_directories(folder / target.name);
  int number = 0;
  for (const std::string& seed : target.seeds())
  {
    const std::string name = "seed-" + std::to_string(++number);
    std::ofstream(folder / target.name / name, std::ios::binary) << seed;
  }
  std::ofstream dictionary(folder / (target.name + ".dict"));
  for (const std::string& word : target.words)
  {
    dictionary << Quoted(word);
  }
}

}

int main(int argc, char** argv)
{
  if (argc != 2)
  {
    std::cerr << "Usage: fuzz-seeds FOLDER\n";
    return 2;
  }
  for (const varimarch::FuzzTarget& target : varimarch::FuzzTargets())
  {
    Write(target, argv[1]);
    std::cout << target.name << '\n';
  }
}
