// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Random settings of everything that a user can set, frame after frame. Whatever they are, a frame is
// either refused by one error or finite, >= 0 and without an OpenGL error; nothing crashes or hangs.
//
// usage: ParticipatingMediaSettingsFuzz [FIRST [COUNT]]
//
// A seed is a setting; what fails prints its seed, and is replayed by giving it as FIRST. Five hundred settings
// share a window, whose programs stay compiled; what fails only after others is replayed with them, FIRST
// being the one that the window began with. Steps are at least a fiftieth of the volume, since the work of a
// frame is what its steps ask for.
#include "FuzzedScene.h"

#include <csignal>
#include <cstdlib>
#include <ctime>
#include <iostream>

extern "C" __attribute__((weak)) void __sanitizer_set_death_callback(void (*)());

namespace
{
constexpr unsigned Sharing = 500; // settings of a window
volatile unsigned Current = 0, Began = 0;

void SaySeed()
{
  std::cerr << "\nseed " << Current
            << " ended the process; replay it by: ParticipatingMediaSettingsFuzz " << Current
            << ", or with those before it in its window: " << Began << ' ' << Current - Began + 1
            << "\n";
}

extern "C" void OnSignal(int number)
{
  SaySeed();
  std::signal(number, SIG_DFL);
  std::raise(number);
}

void SaySeedWhenEnded()
{
  if (
    __sanitizer_set_death_callback) // of the address sanitizer; the undefined-behaviour one aborts
  {
    __sanitizer_set_death_callback(SaySeed);
    std::signal(SIGABRT, OnSignal);
    return;
  }
  for (int number : { SIGSEGV, SIGABRT, SIGFPE, SIGILL, SIGTERM })
  {
    std::signal(number, OnSignal);
  }
}
}

int main(int argc, char** argv)
{
  const unsigned first = argc > 1 ? static_cast<unsigned>(std::atoi(argv[1])) : 0;
  const unsigned count = argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 1;
  SaySeedWhenEnded();
  int failed = 0, drawn = 0, refused = 0;
  double longest = 0;
  unsigned slowest = first;
  vtkSmartPointer<vtkRenderWindow> window;
  for (unsigned seed = first; seed - first < count; ++seed)
  {
    if ((seed - first) % Sharing == 0)
    {
      window = vtkSmartPointer<vtkRenderWindow>::New();
      Began = seed;
    }
    Current = seed;
    vtkMediumStress::FuzzedScene scene(seed, window);
    for (int frame = 0; frame < vtkMediumStress::FuzzedScene::Frames; ++frame)
    {
      const std::clock_t start = std::clock(); // of the processor: machines are shared
      const std::string problem = scene.Frame(frame);
      const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
      if (seconds > longest)
      {
        longest = seconds;
        slowest = seed;
      }
      ++(scene.WasRefused() ? refused : drawn);
      if (!problem.empty())
      {
        std::cerr << "seed " << seed << ", frame " << frame << ": " << problem << "\n"
                  << (count == 1 ? scene.Describe() : std::string());
        ++failed;
      }
    }
  }
  std::cout << count << " settings from seed " << first << ": " << drawn << " frames drawn, "
            << refused << " refused, " << failed << " failed; the longest took " << longest
            << " s of a processor (seed " << slowest << ")\n";
  return failed > 0 || drawn == 0 || refused == 0 ? 1 : 0;
}
