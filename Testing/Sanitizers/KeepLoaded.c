/* SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Loaded ahead of all else in sanitized tests: libraries stay loaded to the end, so that a leak in
 * the OpenGL driver, which is unloaded with its window, has a name that leaks.supp can suppress. */
int dlclose(void* library)
{
  (void)library;
  return 0;
}
