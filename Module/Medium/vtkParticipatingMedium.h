// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkParticipatingMedium
 * @brief What fills a volume: extinction, albedo, emission and phase function, in physical units.
 *
 * All coefficients are per world unit of length.
 *
 * @sa vtkSingleScatteringVolumeMapper vtkSingleScatteringReference
 */
#ifndef vtkParticipatingMedium_h
#define vtkParticipatingMedium_h

#include "vtkMediumCompatibility.h"
#include "vtkObject.h"
#include "vtkParticipatingMediumModule.h" // for the export macro

class VTKPARTICIPATINGMEDIUM_EXPORT vtkParticipatingMedium : public vtkObject
{
public:
  static vtkParticipatingMedium* New();
  vtkTypeMacro(vtkParticipatingMedium, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkParticipatingMedium();
  ~vtkParticipatingMedium() override;

private:
  vtkParticipatingMedium(const vtkParticipatingMedium&) = delete;
  void operator=(const vtkParticipatingMedium&) = delete;
};

#endif
