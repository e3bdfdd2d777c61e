// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumStepSearch
 * @brief Halves a step until what the last halving changed says that an image is accurate enough.
 *
 * With changes d1 and then d2, the order shows in d1 / d2 and the error that is left is about
 * d2 / (d1 / d2 - 1) (Richardson). A search can be gone on with where a smaller error is wanted later.
 */
#ifndef vtkMediumStepSearch_h
#define vtkMediumStepSearch_h

#include "vtkParticipatingMediaRenderingModule.h" // for the export macro

#include <functional>
#include <vector>

class VTKPARTICIPATINGMEDIARENDERING_EXPORT vtkMediumStepSearch
{
public:
  /// R, G, B, alpha of each pixel.
  using Image = std::vector<float>;
  using Integrate = std::function<Image(double step)>;

  vtkMediumStepSearch() = default;
  /// So many times what the changes say is held against the error; steps are tried from the coarsest on, until
  /// about the finest.
  vtkMediumStepSearch(double safety, double coarsest, double finest);

  /// Halves until the error, as a fraction of the image's peak, is at most the maximum, or the step the finest;
  /// at least twice, so that an order is seen.
  void Halve(double maximumError, const Integrate& integrate);

  bool IsBegun() const { return !this->Fine.empty(); }
  bool IsFinest() const { return this->Step <= this->Finest; }
  /// The image of the shortest step so far, that step and its estimated error.
  const Image& GetImage() const { return this->Fine; }
  double GetStep() const { return this->Step; }
  double GetError() const { return this->IsBegun() ? this->Errors.back() : 0; }

  /// The longest step that keeps the error, if the order that was seen last holds there; shorter than any that
  /// seemed to miss it.
  double GetLongestStep(double maximumError) const;
  /// The estimated error there.
  double GetErrorAt(double step) const;

  /// The largest difference of two images of the same pixels: of radiance, as a fraction of the second's
  /// peak, or of alpha, whichever is greater.
  static double RelativeDifference(const Image& image, const Image& other);
  static double PeakOf(const Image& image);

private:
  void HalveOnce(const Integrate& integrate);

  double Safety = 1;
  double Finest = 0;
  double Step = 0;
  std::vector<double> Errors; ///< after each halving
  double Before = -1;         ///< the change of the last halving
  double Ratio = 2;           ///< of successive changes
  Image Fine;
};

#endif
