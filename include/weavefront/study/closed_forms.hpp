#pragma once
/// @file
/// Closed forms that studies compare with.

namespace weavefront::study {

/// Stress of a three-element yarn strained from rest at a constant rate, Pa: E1 r t + (Ka - E1) r tau (1 -
/// e^{-t/tau}).
/// @param static_modulus E1, Pa @param hooke_modulus Ka, Pa @param tau relaxation time, s; 0: elastic @param
/// rate r, 1/s @param time t, s
double constant_rate_stress(double static_modulus, double hooke_modulus, double tau, double rate,
                            double time);

/// Transverse impact on a long straight elastic yarn, J. C. Smith (1958).
struct SmithImpact {
    double strain;            ///< behind the longitudinal front, 1
    double transverse_speed;  ///< of the kink in the laboratory, m/s
};

/// @param speed of the impact, m/s @param wave_speed longitudinal, m/s
SmithImpact smith_impact(double speed, double wave_speed);

}  // namespace weavefront::study
