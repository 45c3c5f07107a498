#include <algorithm>
#include <cmath>

#include "firmware/core/stabilizer/gradual.hpp"
#include "tools/floor/criteria_quantities.hpp"

namespace surefoot::floor {
namespace {

using stabilizer::toward;

/// One sample of each landing for which `sample` has one.
template <typename Sample>
Samples of_landings(const ObservedWalk& walk, Sample sample) {
  Samples samples;
  for (const Landing& landing : landings_of(walk)) sample(landing, samples);
  return samples;
}

double rate_toward_rad_s(const ObservedTick& tick, Side foot) noexcept {
  return toward(foot, tick.hip_roll_rate_rad_s[index(opposite(foot))]);
}

/// Distance of a foot from the other one, outwards.
double outward_m(const ObservedTick& tick, Side foot) noexcept {
  return lateral_sign(foot) * (tick.foot_body_m[index(foot)].y() - tick.foot_body_m[index(opposite(foot))].y());
}

/// Last tick of the swing before `contact` in which the landing position may still change.
const ObservedTick* settled(const ObservedWalk& walk, std::size_t contact) noexcept {
  const stabilizer::LandingPositionConfig& law = walk.config.landing_position;
  for (std::size_t i = contact; i-- > 0;) {
    const stabilizer::WalkView& view = walk.ticks[i].walk;
    const bool is_frozen =
        view.is_double_support || view.has_landed || (1.0 - view.swing_share) * law.single_support_s < law.freeze_s;
    if (!is_frozen) return &walk.ticks[i];
  }
  return nullptr;
}

}  // namespace

Samples early_landing_peak_n(const ObservedWalk& walk) {
  return of_landings(walk, [&](const Landing& landing, Samples& samples) {
    if (landing.swing_share >= walk.config.shock_absorber.latest_share) return;
    double peak_n = 0.0;
    for (std::size_t i = landing.contact; i < landing.step_end; ++i) {
      peak_n = std::max(peak_n, walk.ticks[i].force_n[index(landing.foot)]);
    }
    samples.push_back(peak_n);
  });
}

Samples landing_error_ms(const ObservedWalk& walk) {
  return of_landings(walk, [&](const Landing& landing, Samples& samples) {
    const double late_s =
        walk.period_s * (static_cast<double>(landing.contact) - static_cast<double>(landing.step_end));
    samples.push_back(1e3 * std::abs(late_s));
  });
}

Samples landed_late_percent(const ObservedWalk& walk) {
  return of_landings(walk, [](const Landing& landing, Samples& samples) {
    samples.push_back(landing.contact > landing.step_end ? 100.0 : 0.0);
  });
}

Samples landed_momentum_error_nms(const ObservedWalk& walk) {
  const stabilizer::LandingMomentumConfig& law = walk.config.landing_momentum;
  return of_landings(walk, [&](const Landing& landing, Samples& samples) {
    const ObservedTick& contact = walk.ticks[landing.contact];
    const double nominal_rad_s = toward(landing.foot, contact.nominal.support_roll_rate_rad_s);
    const double desired_nms = law.uses_nominal ? law.inertia_kg_m2 * nominal_rad_s : law.printed_momentum_nms;
    const auto error_nms = [&](const ObservedTick& tick) {
      return std::abs(law.inertia_kg_m2 * rate_toward_rad_s(tick, landing.foot) - desired_nms);
    };
    if (error_nms(contact) <= law.range_nms) return;
    const std::size_t end = std::min(landing.contact + walk.ticks_in(law.window_s), landing.lift);
    samples.push_back(error_nms(walk.ticks[std::max(end, landing.contact)]));
  });
}

Samples landing_position_error_mm(const ObservedWalk& walk) {
  const stabilizer::LandingPositionConfig& law = walk.config.landing_position;
  return of_landings(walk, [&](const Landing& landing, Samples& samples) {
    const ObservedTick* decided = settled(walk, landing.contact);
    if (decided == nullptr) return;
    const auto distance_m = [&](double rate_rad_s) {
      return stabilizer::landing_distance_m(law, walk.body_mass_kg, toward(landing.foot, rate_rad_s));
    };
    const double before_m =
        law.uses_nominal ? distance_m(decided->nominal.support_roll_rate_rad_s) : law.printed_distance_m;
    const double wanted_m = std::clamp(law.kp * (distance_m(decided->measured.support_roll_rate_rad_s) - before_m),
                                       -law.max_shift_m, law.max_shift_m);
    const double pattern_m = 2.0 * walk.foot_offset_y_m;
    samples.push_back(1e3 * std::abs(outward_m(walk.ticks[landing.contact], landing.foot) - pattern_m - wanted_m));
  });
}

Samples landing_moment_peak_nm(const ObservedWalk& walk) {
  return of_landings(walk, [&](const Landing& landing, Samples& samples) {
    double peak_nm = 0.0;
    for (std::size_t i = landing.contact; i < landing.lift; ++i) {
      const estimation::AnkleLoad& load = walk.ticks[i].ankle[index(landing.foot)];
      peak_nm = std::max(peak_nm, std::hypot(load.roll_moment_nm, load.pitch_moment_nm));
    }
    samples.push_back(peak_nm);
  });
}

}  // namespace surefoot::floor
