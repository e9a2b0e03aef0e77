// Square-root free, row by row.
#include "analysis/scaling/cholesky.h"

#include <algorithm>
#include <cmath>

namespace analysis::scaling {

bool Cholesky::factor(std::span<const double> matrix, std::size_t n) {
    n_ = n;
    lower_.assign(matrix.begin(), matrix.end());
    for (std::size_t i = 0; i < n; ++i) {
        double* row = &lower_[i * n];
        for (std::size_t j = 0; j < i; ++j) { // row[j] becomes L(i, j) D(j)
            const double* other = &lower_[j * n];
            double sum = row[j];
            for (std::size_t k = 0; k < j; ++k)
                sum -= row[k] * other[k];
            row[j] = sum;
        }
        double pivot = row[i];
        for (std::size_t j = 0; j < i; ++j) {
            const double unit = row[j] / lower_[j * n + j];
            pivot -= row[j] * unit;
            row[j] = unit;
        }
        if (!(pivot > 0))
            return false;
        row[i] = pivot;
    }
    return true;
}

void Cholesky::solve(std::span<double> b) const {
    for (std::size_t i = 0; i < n_; ++i)
        for (std::size_t k = 0; k < i; ++k)
            b[i] -= lower_[i * n_ + k] * b[k];
    for (std::size_t i = 0; i < n_; ++i)
        b[i] /= lower_[i * n_ + i];
    for (std::size_t i = n_; i-- > 0;)
        for (std::size_t k = 0; k < i; ++k)
            b[k] -= lower_[i * n_ + k] * b[i];
}

double Cholesky::log_determinant() const {
    double sum = 0;
    for (std::size_t i = 0; i < n_; ++i)
        sum += std::log(lower_[i * n_ + i]);
    return sum;
}

std::vector<double> Cholesky::inverse() const {
    std::vector<double> result(n_ * n_);
    std::vector<double> column(n_);
    for (std::size_t i = 0; i < n_; ++i) {
        std::fill(column.begin(), column.end(), 0.0);
        column[i] = 1;
        solve(column);
        for (std::size_t j = 0; j <= i; ++j)
            result[i * n_ + j] = result[j * n_ + i] = column[j];
    }
    return result;
}

} // namespace analysis::scaling
