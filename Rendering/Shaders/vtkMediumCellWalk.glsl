// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Where a ray crosses the faces of the cells in which the fields are smooth.

// Box coordinate to a coordinate that is an integer on the faces: one for each kind of field that there is,
// on points or on cells, linear or nearest.
uniform vec3 latticeScale[LATTICE_COUNT];
uniform vec3 latticeBias[LATTICE_COUNT];

// A face nearer than this, in cells, counts as the one that the ray stands on.
#define CELL_WALK_SLIVER 2.0e-4
// The shortest step, local units, so that every walk ends.
#define CELL_WALK_LEAST 1.0e-6

// The t of the first face of one lattice after t, at most end.
float cellWalkLattice(vec3 origin, vec3 along, float t, float end)
{
  vec3 at = origin + t * along;
  vec3 upper = floor(at + CELL_WALK_SLIVER) + 1.0;
  vec3 lower = ceil(at - CELL_WALK_SLIVER) - 1.0;
  float next = end;
  next = along.x > 1.0e-20 ? min(next, (upper.x - origin.x) / along.x) : next;
  next = along.x < -1.0e-20 ? min(next, (lower.x - origin.x) / along.x) : next;
  next = along.y > 1.0e-20 ? min(next, (upper.y - origin.y) / along.y) : next;
  next = along.y < -1.0e-20 ? min(next, (lower.y - origin.y) / along.y) : next;
  next = along.z > 1.0e-20 ? min(next, (upper.z - origin.z) / along.z) : next;
  next = along.z < -1.0e-20 ? min(next, (lower.z - origin.z) / along.z) : next;
  return next;
}

float cellWalkNext(vec3 start, vec3 along, float t, float end)
{
  float next = cellWalkLattice(
    start * latticeScale[0] + latticeBias[0], along * latticeScale[0], t, end);
#if LATTICE_COUNT > 1
  next = cellWalkLattice(
    start * latticeScale[1] + latticeBias[1], along * latticeScale[1], t, next);
#endif
#if LATTICE_COUNT > 2
  next = cellWalkLattice(
    start * latticeScale[2] + latticeBias[2], along * latticeScale[2], t, next);
#endif
#if LATTICE_COUNT > 3
  next = cellWalkLattice(
    start * latticeScale[3] + latticeBias[3], along * latticeScale[3], t, next);
#endif
  return next;
}
