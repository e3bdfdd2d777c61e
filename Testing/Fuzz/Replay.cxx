// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// A fuzz target without a fuzzer: runs it on files of bytes, and on random bytes.
//
// usage: PROGRAM [--seeds FIRST COUNT] [FILE...]
//
// A seed stands for up to 1024 random bytes. What fails prints its seed or file, and is replayed by it.
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include <csignal>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
extern "C" __attribute__((weak)) void __sanitizer_set_death_callback(void (*)());

namespace
{
std::string Current;

void Say()
{
  std::cerr << "\nended by: " << Current << "\n";
}

extern "C" void OnSignal(int number)
{
  Say();
  std::signal(number, SIG_DFL);
  std::raise(number);
}

std::vector<std::uint8_t> MakeBytes(unsigned seed)
{
  std::mt19937 generator(seed);
  std::vector<std::uint8_t> bytes(generator() % 1024);
  for (std::uint8_t& byte : bytes)
  {
    byte = static_cast<std::uint8_t>(generator() >> 24);
  }
  return bytes;
}
}

int main(int argc, char** argv)
{
  if (__sanitizer_set_death_callback)
  {
    __sanitizer_set_death_callback(Say);
  }
  for (int number : { SIGABRT, SIGSEGV, SIGFPE, SIGTERM })
  {
    std::signal(number, OnSignal);
  }
  unsigned inputs = 0;
  const auto run = [&inputs](const std::string& name, const std::vector<std::uint8_t>& bytes) {
    Current = name;
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
    ++inputs;
  };
  for (int i = 1; i < argc; ++i)
  {
    if (std::string(argv[i]) == "--seeds" && i + 2 < argc)
    {
      const unsigned first = std::strtoul(argv[i + 1], nullptr, 10);
      const unsigned count = std::strtoul(argv[i + 2], nullptr, 10);
      for (unsigned seed = first; seed - first < count; ++seed)
      {
        run("--seeds " + std::to_string(seed) + " 1", MakeBytes(seed));
      }
      i += 2;
      continue;
    }
    std::ifstream file(argv[i], std::ios::binary);
    if (!file)
    {
      std::cerr << "cannot read " << argv[i] << "\n";
      return 1;
    }
    run(argv[i], { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() });
  }
  std::cout << inputs << " inputs\n";
  return inputs > 0 ? 0 : 1;
}
