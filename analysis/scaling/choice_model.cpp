// The information of the scores is a weighted graph Laplacian: it does not see a common shift.  A
// multiple of 11^T fills that direction, sized like the rest so that nothing is lost beside it.
#include "analysis/scaling/choice_model.h"

#include "protocols/contract.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace analysis::scaling {
namespace {

constexpr int most_iterations = 200; // 1e15 : 1 takes 41; Firth's scoring steps converge linearly
constexpr int most_halvings = 40;

double largest_magnitude(std::span<const double> values) {
    double largest = 0;
    for (const double value : values)
        largest = std::max(largest, std::abs(value));
    return largest;
}

double mean(std::span<const double> values) {
    double sum = 0;
    for (const double value : values)
        sum += value;
    return sum / static_cast<double>(values.size());
}

// Whether two steps point apart; an empty one does not.
bool opposed(std::span<const double> a, std::span<const double> b) {
    double product = 0;
    for (std::size_t i = 0; i < b.size(); ++i)
        product += a[i] * b[i];
    return product < 0;
}

void centre(std::span<double> values) {
    const double middle = mean(values);
    for (double& value : values)
        value -= middle;
}

} // namespace

ChoiceModel::ChoiceModel(std::size_t conditions,
                         std::vector<Comparison> comparisons,
                         ModelTerms terms)
    : t_(conditions), parameters_(conditions), comparisons_(std::move(comparisons)), terms_(terms) {
    EXPECTS(conditions > 0 && terms.ridge >= 0);
    EXPECTS(!terms.ties || (terms.link == Link::Logit && !terms.firth));
    EXPECTS(!terms.firth || (terms.link == Link::Logit && !terms.side && terms.ridge == 0));
    for (const auto& pair : comparisons_)
        EXPECTS(pair.first < t_ && pair.second < t_ && pair.first != pair.second);
    if (terms.side)
        side_at_ = parameters_++;
    if (terms.ties)
        nu_at_ = parameters_++;
}

bool ChoiceModel::evaluate(std::span<const double> parameters, ModelPoint& point) {
    point.log_likelihood = 0;
    point.gradient.assign(parameters_, 0.0);
    point.information.assign(parameters_ * parameters_, 0.0);
    for (const auto& pair : comparisons_)
        terms_.ties ? add_tied_pair(pair, parameters, point) : add_pair(pair, parameters, point);
    point.objective = point.log_likelihood;
    if (terms_.ridge > 0)
        add_ridge(parameters, point);
    return !terms_.firth || add_firth(parameters, point);
}

void ChoiceModel::add_pair(const Comparison& pair,
                           std::span<const double> parameters,
                           ModelPoint& point) {
    const std::size_t i = pair.first, j = pair.second, p = parameters_;
    const double d = parameters[i] - parameters[j] + (terms_.side ? parameters[side_at_] : 0);
    const PairTerm term = terms_.link == Link::Logit
                              ? logit_term(d, pair.first_wins, pair.second_wins)
                              : probit_term(d, pair.first_wins, pair.second_wins);
    point.log_likelihood += term.log_likelihood;
    point.gradient[i] += term.slope;
    point.gradient[j] -= term.slope;
    auto& m = point.information;
    m[i * p + i] += term.curvature;
    m[j * p + j] += term.curvature;
    m[i * p + j] -= term.curvature;
    m[j * p + i] -= term.curvature;
    if (!terms_.side)
        return;
    const std::size_t s = side_at_;
    point.gradient[s] += term.slope;
    m[s * p + s] += term.curvature;
    m[s * p + i] += term.curvature;
    m[i * p + s] += term.curvature;
    m[s * p + j] -= term.curvature;
    m[j * p + s] -= term.curvature;
}

void ChoiceModel::add_tied_pair(const Comparison& pair,
                                std::span<const double> parameters,
                                ModelPoint& point) {
    const std::size_t p = parameters_;
    const double d =
        parameters[pair.first] - parameters[pair.second] + (terms_.side ? parameters[side_at_] : 0);
    const TiedPairTerm term =
        davidson_term(d, parameters[nu_at_], pair.first_wins, pair.second_wins, pair.ties);
    // d depends on each of these with the sign beside it.
    const std::pair<std::size_t, double> dependence[3] = {
        {pair.first, 1.0}, {pair.second, -1.0}, {side_at_, 1.0}};
    const std::size_t many = terms_.side ? 3 : 2;
    point.log_likelihood += term.log_likelihood;
    auto& m = point.information;
    for (std::size_t a = 0; a < many; ++a) {
        const auto [at, sign] = dependence[a];
        point.gradient[at] += sign * term.slope;
        for (std::size_t b = 0; b < many; ++b)
            m[at * p + dependence[b].first] += sign * dependence[b].second * term.curvature;
        m[at * p + nu_at_] += sign * term.curvature_cross;
        m[nu_at_ * p + at] += sign * term.curvature_cross;
    }
    point.gradient[nu_at_] += term.slope_nu;
    m[nu_at_ * p + nu_at_] += term.curvature_nu;
}

void ChoiceModel::add_ridge(std::span<const double> parameters, ModelPoint& point) const {
    const auto theta = parameters.first(t_);
    const double middle = mean(theta);
    for (std::size_t i = 0; i < t_; ++i) {
        point.objective -= terms_.ridge / 2 * (theta[i] - middle) * (theta[i] - middle);
        point.gradient[i] -= terms_.ridge * (theta[i] - middle);
        point.information[i * parameters_ + i] += terms_.ridge;
        for (std::size_t j = 0; j < t_; ++j)
            point.information[i * parameters_ + j] -= terms_.ridge / static_cast<double>(t_);
    }
}

// Jeffreys' prior adds half the log-determinant of the information; each pair's slope gains its
// leverage h times (1/2 - P).
bool ChoiceModel::add_firth(std::span<const double> parameters, ModelPoint& point) {
    double filled = 0;
    if (!factor(point, filled))
        return false;
    point.objective += (cholesky_.log_determinant() - std::log(filled)) / 2;
    const auto inverse = cholesky_.inverse(); // the filled direction cancels in differences
    for (const auto& pair : comparisons_) {
        const std::size_t i = pair.first, j = pair.second;
        const double d = parameters[i] - parameters[j];
        const double variance = inverse[i * t_ + i] + inverse[j * t_ + j] - 2 * inverse[i * t_ + j];
        const double weight = logit_term(d, pair.first_wins, pair.second_wins).curvature;
        const double pull = -weight * variance * std::tanh(d / 2) / 2;
        point.gradient[i] += pull;
        point.gradient[j] -= pull;
    }
    return true;
}

double ChoiceModel::fill_null_space(std::vector<double>& information) const {
    double trace = 0;
    for (std::size_t i = 0; i < t_; ++i)
        trace += information[i * parameters_ + i];
    const double filled = trace > 0 ? trace / static_cast<double>(t_) : 1.0;
    for (std::size_t i = 0; i < t_; ++i)
        for (std::size_t j = 0; j < t_; ++j)
            information[i * parameters_ + j] += filled / static_cast<double>(t_);
    return filled;
}

bool ChoiceModel::factor(const ModelPoint& point, double& filled) {
    matrix_ = point.information;
    filled = fill_null_space(matrix_);
    return cholesky_.factor(matrix_, parameters_);
}

void ChoiceModel::newton_step(const ModelPoint& point, std::vector<double>& step) {
    step = point.gradient;
    cholesky_.solve(step);
    centre(std::span(step).first(t_));
}

ChoiceModel::Maximum ChoiceModel::maximise(std::span<const double> start, double close) {
    EXPECTS(start.empty() || start.size() == parameters_);
    Maximum at;
    at.parameters.assign(start.begin(), start.end());
    at.parameters.resize(parameters_, 0.0);
    ModelPoint here, there;
    std::vector<double> step, taken, next(parameters_);
    double filled = 0, before = 0, damping = 1;
    if (!evaluate(at.parameters, here))
        return at;
    while (at.iterations < most_iterations && factor(here, filled)) {
        ++at.iterations;
        newton_step(here, step);
        const double size = largest_magnitude(step);
        const double scale = 1 + largest_magnitude(at.parameters);
        // Rounding keeps a step above its bound where the information is tiny: it stops shrinking.
        const bool last = size <= close * scale ||
                          (at.iterations > 1 && size <= 1e-12 * scale && size >= before / 2);
        // Firth's penalty curves the objective more than the information tells, twice as much where
        // votes are few: full steps would swing about the maximum for ever.
        if (terms_.firth && size > 0.7 * before && opposed(step, taken))
            damping = std::max(damping / 2, 1.0 / 16);
        taken = step;
        before = size;
        double fraction = damping;
        for (int halving = 0; halving < most_halvings; ++halving, fraction /= 2) {
            for (std::size_t k = 0; k < parameters_; ++k)
                next[k] = at.parameters[k] + fraction * step[k];
            const double allowance = 1e-13 * (1 + std::abs(here.objective)); // of rounding
            if (evaluate(next, there) && there.objective >= here.objective - allowance)
                break;
        }
        std::swap(at.parameters, next);
        std::swap(here, there);
        if (last) {
            at.converged = true;
            break;
        }
    }
    centre(std::span(at.parameters).first(t_));
    at.log_likelihood = here.log_likelihood;
    return at;
}

std::vector<double> ChoiceModel::covariance(std::span<const double> parameters) {
    ModelPoint point;
    double filled = 0;
    if (!evaluate(parameters, point) || !factor(point, filled))
        return std::vector<double>(parameters_ * parameters_, std::nan(""));
    auto inverse = cholesky_.inverse();
    const double shift = 1 / (filled * static_cast<double>(t_));
    for (std::size_t i = 0; i < t_; ++i)
        for (std::size_t j = 0; j < t_; ++j)
            inverse[i * parameters_ + j] -= shift;
    return inverse;
}

} // namespace analysis::scaling
