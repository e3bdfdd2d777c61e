// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Where a lattice's values lie in a 3D texture (vtkMediumFold). FOLDED, lattices lie in blocks, and a lattice
// coordinate becomes a coordinate of the texture; else they are textures as they are, the coordinates that
// look-ups compute are the texture's own, and nothing is left of this.

#ifdef FOLDED
struct Fold
{
  vec3 last;   // index of the last value along each axis
  vec3 blocks; // number of them along each axis of the lattice
  vec3 stride; // values from a block to the next
  vec3 extent; // texels of a block
  vec3 beside; // blocks along each axis of the texture
};
#define FOLD(name) uniform Fold name;

// From texels, 0 at the centre of the first, of a lattice coordinate, 0 at the first value. Which of two
// blocks takes the layer that they share does not matter, and so nor does the rounding of quotients.
vec3 foldTexels(Fold fold, vec3 lattice)
{
  vec3 at = clamp(lattice, vec3(0.0), fold.last);
  vec3 block = min(floor(at / fold.stride), fold.blocks - 1.0);
  float number = block.x + fold.blocks.x * (block.y + fold.blocks.y * block.z);
  float row = floor((number + 0.5) / fold.beside.x); // halves, so that no rounding reaches a whole number
  float layer = floor((row + 0.5) / fold.beside.y);
  vec3 place = vec3(number - row * fold.beside.x, row - layer * fold.beside.y, layer);
  return place * fold.extent + clamp(at - block * fold.stride, vec3(0.0), fold.extent - 1.0);
}

#define foldPlace(fold, lattice)                                                                   \
  ((foldTexels(fold, lattice) + 0.5) / ((fold).beside * (fold).extent))
#define foldTexel(fold, lattice) ivec3(foldTexels(fold, lattice) + 0.5)
#else
#define FOLD(name)
#define foldPlace(fold, coordinate) (coordinate)
#define foldTexel(fold, lattice) ivec3(lattice)
#endif
