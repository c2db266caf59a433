#include "weavefront/study/closed_forms.hpp"

#include <cmath>

namespace weavefront::study {

double constant_rate_stress(double static_modulus, double hooke_modulus, double tau, double rate,
                            double time) {
    const double relaxed = tau > 0 ? -tau * std::expm1(-time / tau) : 0;
    return static_modulus * rate * time + (hooke_modulus - static_modulus) * rate * relaxed;
}

SmithImpact smith_impact(double speed, double wave_speed) {
    double low = 0, high = 1;  // the speed grows with the strain
    for (int i = 0; i < 200; ++i) {
        const double e = (low + high) / 2;
        (wave_speed * std::sqrt(2 * e * std::sqrt(e * (1 + e)) - e * e) < speed ? low : high) = e;
    }
    const double e = (low + high) / 2;
    return {e, wave_speed * (std::sqrt(e * (1 + e)) - e)};
}

}  // namespace weavefront::study
