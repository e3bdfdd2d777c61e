// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Laws of the phase functions, against the definitions of the papers in long double.
#include "FormulaTypes.h"

#include <cmath>
#include <functional>

namespace
{
constexpr long double Pi = 3.141592653589793238462643383279502884L;

// The integral of f(cosTheta) over the sphere: 8-point Gauss-Legendre on intervals that halve
// towards both poles, down to 2^-28, well inside the narrowest lobe ((1 - 0.999)^2 / 2 = 5e-7 in
// cosTheta).
double IntegrateOverSphere(const std::function<double(long double)>& f)
{
  static const long double node[4] = { 0.1834346424956498049L, 0.5255324099163289858L,
    0.7966664774136267396L, 0.9602898564975362317L };
  static const long double weight[4] = { 0.3626837833783619830L, 0.3137066458778872873L,
    0.2223810344533744705L, 0.1012285362903762591L };
  long double sum = 0;
  for (int side = -1; side <= 1; side += 2)
  {
    long double outer = 1;
    for (int level = 0; level < 29; ++level)
    {
      const long double inner = level < 28 ? outer / 2 : 0;
      const long double centre = (outer + inner) / 2, half = (outer - inner) / 2;
      for (int i = 0; i < 8; ++i)
      {
        const long double x = i < 4 ? -node[i] : node[i - 4];
        sum += half * weight[i % 4] * f(side * (1 - (centre + half * x)));
      }
      outer = inner;
    }
  }
  return static_cast<double>(2 * Pi * sum);
}

long double PlainHenyeyGreenstein(long double c, long double g)
{
  return (1 - g * g) / (4 * Pi * std::pow(1 + g * g - 2 * g * c, 1.5L));
}

long double PlainSchlick(long double c, long double k)
{
  return (1 - k * k) / (4 * Pi * (1 - k * c) * (1 - k * c));
}

long double PlainDraine(long double c, long double g, long double alpha)
{
  return PlainHenyeyGreenstein(c, g) * (1 + alpha * c * c) / (1 + alpha * (1 + 2 * g * g) / 3);
}

const double Anisotropies[] = { -1, -0.999, -0.99, -0.97, -0.95, -0.938, -0.9, -0.5, -1e-3, -1e-7,
  0, 1e-7, 1e-3, 0.1, 0.3, 0.6, 0.8, 0.9, 0.938, 0.94, 0.95, 0.96, 0.97, 0.98, 0.99, 0.999, 0.9999,
  1 };
const double Alphas[] = { 0, 0.5, 1, 10, 250 };
}

template <typename F>
class FormulasPhase : public ::testing::Test
{
protected:
  // In float, 1 - 0.999 is rounded by 6e-5 of itself. Double keeps the rule's own accuracy.
  static constexpr double SphereTolerance = sizeof(typename F::real) == 4 ? 2e-4 : 1e-8;
};
TYPED_TEST_SUITE(FormulasPhase, FormulaTypes);

TYPED_TEST(FormulasPhase, EachIntegratesToOneOverTheSphere)
{
  using F = TypeParam;
  EXPECT_NEAR(IntegrateOverSphere([](long double) { return F::Isotropic(); }), 1, 1e-6);
  EXPECT_NEAR(IntegrateOverSphere([](long double c) { return F::Rayleigh(c); }), 1, 1e-6);
  for (double g : Anisotropies)
  {
    SCOPED_TRACE(g);
    EXPECT_NEAR(IntegrateOverSphere([g](long double c) { return F::HenyeyGreenstein(c, g); }), 1,
      this->SphereTolerance);
    EXPECT_NEAR(
      IntegrateOverSphere([g](long double c) { return F::Schlick(c, F::SchlickFromG(g)); }), 1,
      this->SphereTolerance);
    EXPECT_NEAR(IntegrateOverSphere([g](long double c) { return F::Schlick(c, g); }), 1,
      this->SphereTolerance);
    EXPECT_NEAR(IntegrateOverSphere(
                  [g](long double c) { return F::DoubleHenyeyGreenstein(c, g, -0.4, 0.75); }),
      1, this->SphereTolerance);
    for (double alpha : Alphas)
    {
      EXPECT_NEAR(IntegrateOverSphere([=](long double c) { return F::Draine(c, g, alpha); }), 1,
        this->SphereTolerance);
      EXPECT_NEAR(
        IntegrateOverSphere([=](long double c) { return F::Droplets(c, g, alpha, 0.98, 0.4); }), 1,
        this->SphereTolerance);
    }
  }
}

TYPED_TEST(FormulasPhase, EachIsFiniteAndNonNegativeForEveryAnisotropy)
{
  using F = TypeParam;
  for (double g : Anisotropies)
  {
    for (int i = -1001; i <= 1001; ++i)
    {
      const double c = i / 1001.0;
      for (double p :
        { double(F::HenyeyGreenstein(c, g)), double(F::Schlick(c, g)),
          double(F::Schlick(c, F::SchlickFromG(g))), double(F::Draine(c, g, 250)),
          double(F::DoubleHenyeyGreenstein(c, g, -g, 0.3)), double(F::Droplets(c, g, 9, -g, 1)) })
      {
        ASSERT_TRUE(std::isfinite(p) && p >= 0) << "g " << g << " cosTheta " << c << " p " << p;
      }
    }
  }
}

TYPED_TEST(FormulasPhase, EachMeetsItsDefinition)
{
  using F = TypeParam;
  using real = typename F::real;
  // A handful of roundings, at the same rounded arguments. The definition itself cancels: at the
  // peak of g = 0.999 long double's 1e-19 is 1e-13 of 1 + g^2 - 2 g c.
  const double tolerance = 16 * Epsilon<F>() + 2e-13;
  for (double anisotropy : Anisotropies)
  {
    const real g = static_cast<real>(anisotropy);
    const real limit = static_cast<real>(0.999);
    const real held = std::min(std::max(g, -limit), limit);
    for (int i = -500; i <= 500; ++i)
    {
      const real c = static_cast<real>(i / 500.0);
      ASSERT_NEAR(F::HenyeyGreenstein(c, g) / PlainHenyeyGreenstein(c, held), 1, tolerance) << g;
      ASSERT_NEAR(F::Schlick(c, g) / PlainSchlick(c, held), 1, tolerance) << g;
      for (double alpha : Alphas)
      {
        const real a = static_cast<real>(alpha);
        ASSERT_NEAR(F::Draine(c, g, a) / PlainDraine(c, held, a), 1, tolerance) << g;
      }
    }
  }
  for (double g : { -0.9, -0.3, 0.0, 0.2, 0.5, 0.9, 0.92 })
  {
    ASSERT_NEAR(F::SchlickFromG(g), 1.55 * g - 0.55 * g * g * g, tolerance);
  }
}

TYPED_TEST(FormulasPhase, PositiveAnisotropyScattersForwardAndSignsMirror)
{
  using F = TypeParam;
  using real = typename F::real;
  for (double anisotropy : { 0.01, 0.3, 0.8, 0.95, 0.999, 1.0 })
  {
    const real g = static_cast<real>(anisotropy);
    EXPECT_GT(F::HenyeyGreenstein(1, g), F::HenyeyGreenstein(-1, g));
    EXPECT_GT(F::Schlick(1, g), F::Schlick(-1, g));
    EXPECT_GT(F::Schlick(1, F::SchlickFromG(g)), F::Schlick(-1, F::SchlickFromG(g)));
    EXPECT_GT(F::Draine(1, g, 2), F::Draine(-1, g, 2));
    EXPECT_GT(F::DoubleHenyeyGreenstein(1, g, 0, 0.5), F::DoubleHenyeyGreenstein(-1, g, 0, 0.5));
    EXPECT_GT(F::Droplets(1, g, 2, 0, 0.5), F::Droplets(-1, g, 2, 0, 0.5));
    for (real c : { real(-1), real(-0.4), real(0), real(0.7), real(1) })
    {
      EXPECT_EQ(F::HenyeyGreenstein(c, g), F::HenyeyGreenstein(-c, -g));
      EXPECT_EQ(F::Schlick(c, g), F::Schlick(-c, -g));
      EXPECT_EQ(F::Draine(c, g, 3), F::Draine(-c, -g, 3));
    }
  }
}

TYPED_TEST(FormulasPhase, MeanCosineOfHenyeyGreensteinIsG)
{
  using F = TypeParam;
  for (double g : Anisotropies)
  {
    const double held = std::min(std::max(g, -0.999), 0.999);
    EXPECT_NEAR(IntegrateOverSphere([g](long double c) { return c * F::HenyeyGreenstein(c, g); }),
      held, this->SphereTolerance);
  }
}

TYPED_TEST(FormulasPhase, SmallAnisotropyIsIsotropic)
{
  using F = TypeParam;
  for (double g : { -1e-3, -1e-5, 0.0, 1e-9, 1e-3 })
  {
    for (double c : { -1.0, -0.2, 0.0, 0.5, 1.0 })
    {
      const double tolerance =
        4 * std::abs(g) + 4 * Epsilon<F>(); // p = (1 + 3 g c) / 4 pi + O(g^2)
      EXPECT_NEAR(F::HenyeyGreenstein(c, g) / F::Isotropic(), 1, tolerance);
      EXPECT_NEAR(F::Schlick(c, F::SchlickFromG(g)) / F::Isotropic(), 1, tolerance);
      EXPECT_NEAR(F::Draine(c, g, 0) / F::Isotropic(), 1, tolerance);
    }
  }
}

TYPED_TEST(FormulasPhase, DraineContainsRayleighAndHenyeyGreenstein)
{
  using F = TypeParam;
  for (double c : { -1.0, -0.3, 0.0, 0.6, 1.0 })
  {
    EXPECT_NEAR(F::Draine(c, 0, 1) / F::Rayleigh(c), 1, 8 * Epsilon<F>());
    EXPECT_NEAR(F::Draine(c, 0.7, 0) / F::HenyeyGreenstein(c, 0.7), 1, 8 * Epsilon<F>());
    EXPECT_NEAR(F::Droplets(c, 0.4, 5, 0.9, 1) / F::Draine(c, 0.4, 5), 1, 8 * Epsilon<F>());
    EXPECT_NEAR(F::Droplets(c, 0.4, 5, 0.9, 0) / F::HenyeyGreenstein(c, 0.9), 1, 8 * Epsilon<F>());
    EXPECT_NEAR(F::DoubleHenyeyGreenstein(c, 0.4, -0.9, 1) / F::HenyeyGreenstein(c, 0.4), 1,
      8 * Epsilon<F>());
  }
}

TYPED_TEST(FormulasPhase, TableCoordinateRunsFromBackToForward)
{
  using F = TypeParam;
  EXPECT_EQ(F::TableCoordinate(-1, 181), 0);
  EXPECT_EQ(F::TableCoordinate(0, 181), 90);
  EXPECT_EQ(F::TableCoordinate(1, 181), 180);
  EXPECT_EQ(F::TableCoordinate(1 + 2 * Epsilon<F>(), 181), 180);
}

// Both distances of the angle, to all of their digits, from unit vectors in the number type. The cosine,
// which is all that a dot product gives, has lost them: as many as the peak is narrow.
TYPED_TEST(FormulasPhase, AngleKeepsTheDigitsThatAPeakNeeds)
{
  using F = TypeParam;
  using real = typename F::real;
  using vec3 = typename F::vec3;
  const vec3 eye = glm::normalize(vec3(real(0.3), real(-0.5), real(0.8)));
  const vec3 side = glm::normalize(glm::cross(eye, vec3(0, 1, 0)));
  for (double g : { -0.999, -0.99, 0.99, 0.999 })
  {
    SCOPED_TRACE(g);
    double angleError = 0, cosineError = 0;
    for (double theta : { 0.0, 1e-4, 5e-4, 1e-3, 3e-3, 1e-2, 0.1 }) // about the peak
    {
      const vec3 ahead = real(std::cos(theta)) * eye + real(std::sin(theta)) * side;
      const vec3 light = glm::normalize(g > 0 ? ahead : -ahead);
      // The angle that these two rounded vectors have.
      glm::tvec3<long double> a(light), b(eye);
      a /= std::sqrt(glm::dot(a, a));
      b /= std::sqrt(glm::dot(b, b));
      const long double apart = glm::dot(a - b, a - b) / 2, together = glm::dot(a + b, a + b) / 2;
      const long double held = std::abs(static_cast<real>(g));
      const long double away = g > 0 ? apart : together;
      const long double d = (1 - held) * (1 - held) + 2 * held * away;
      const long double truth = (1 - held * held) / (4 * Pi * d * std::sqrt(d));
      const double byAngle =
        F::HenyeyGreenstein(F::Angle(light, eye), static_cast<real>(g)) / truth;
      const real cosine = glm::dot(light, eye);
      const double byCosine =
        F::HenyeyGreenstein(static_cast<long double>(cosine), static_cast<real>(g)) / truth;
      angleError = std::max(angleError, std::abs(byAngle - 1));
      cosineError = std::max(cosineError, std::abs(byCosine - 1));
    }
    this->RecordProperty("ByAngle" + std::to_string(g), std::to_string(angleError));
    this->RecordProperty("ByCosine" + std::to_string(g), std::to_string(cosineError));
    // Components are rounded by an epsilon, which moves the angle by a few: theta epsilon against
    // (1 - |g|)^2 + theta^2.
    EXPECT_LT(angleError, 8 * Epsilon<F>() / (1 - std::abs(g)));
    EXPECT_GT(cosineError, 10 * angleError); // what the cosine would lose
  }
}
