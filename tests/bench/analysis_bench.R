# The same work in R, as its own packages do it; prints "name,milliseconds,digits".
# Run by analysis_benchmarks, with the folder of test data as its argument.
data_folder <- commandArgs(trailingOnly = TRUE)[1]

milliseconds <- function(work, least = 0.5) {
  runs <- 0
  started <- sum(proc.time()[1:2])
  repeat {
    work()
    runs <- runs + 1
    spent <- sum(proc.time()[1:2]) - started
    if (spent > least) return(1000 * spent / runs)
  }
}

digits <- function(found, expected) min(15.9, -log10(max(abs(found - expected) / abs(expected))))
row <- function(name, time, digits = NA) cat(sprintf("%s,%.6g,%.1f\n", name, time, digits))

file <- file.path(data_folder, "golden/experiment/votes.csv")
count <- function(votes) {
  winner <- ifelse(votes[[ncol(votes)]] == "left", votes$left, votes$right)
  loser <- ifelse(votes[[ncol(votes)]] == "left", votes$right, votes$left)
  table(winner, loser)
}
read_votes <- function() {
  votes <- read.csv(file, stringsAsFactors = FALSE)
  votes$winner <- ifelse(votes$choice == "left", votes$left, votes$right)
  votes$loser <- ifelse(votes$choice == "left", votes$right, votes$left)
  votes
}
scopes <- list(NULL, "observer", "session", "model", "light", c("model", "light"),
               c("observer", "session"), c("observer", "model"),
               c("observer", "session", "model", "light"))
row("seed_study_matrices", milliseconds(function() {
  votes <- read_votes()
  for (scope in scopes) table(votes[c(scope, "winner", "loser")])
}), 15.9)

# A million votes: 100 observers, 20 methods, whole scenes.
pairs <- t(combn(20, 2))
scenes <- ceiling(1e6 / (100 * nrow(pairs)))
many <- data.frame(
  observer = paste0("O", rep(rep(seq_len(100), each = nrow(pairs)), scenes)), session = 1,
  scene = paste0("s", rep(seq_len(scenes), each = 100 * nrow(pairs))),
  left = paste0("c", pairs[, 1]), right = paste0("c", pairs[, 2]))
many <- many[seq_len(1e6), ]
set.seed(1)
many$chosen <- sample(c("left", "right"), 1e6, replace = TRUE)
large <- tempfile(fileext = ".csv")
write.csv(many, large, row.names = FALSE, quote = FALSE)
row("million_votes", milliseconds(function() {
  votes <- read.csv(large, stringsAsFactors = FALSE)
  votes$winner <- ifelse(votes$chosen == "left", votes$left, votes$right)
  votes$loser <- ifelse(votes$chosen == "left", votes$right, votes$left)
  for (scope in list(NULL, "observer", "session", "scene", c("observer", "session"),
                     c("observer", "scene")))
    table(votes[c(scope, "winner", "loser")])
}), 15.9)
unlink(large)

votes <- read_votes()
rounds <- with(votes, as.data.frame(table(observer, session, model, light, method = winner)))
by_model <- aggregate(Freq ~ observer + model + method, rounds, mean)
means <- aggregate(Freq ~ observer + method, rounds, mean)
f_within <- 0
row("seed_study_anova", milliseconds(function() {
  f_within <<- summary(aov(Freq ~ method + Error(observer / method), means))[[2]][[1]][1, 4]
  summary(aov(Freq ~ method * model + Error(observer / (method * model)), by_model))
  summary(aov(Freq ~ method * model * light * session +
                Error(observer / (method * model * light * session)), rounds))
  for (table in list(means, rounds)) {
    fit <- aov(Freq ~ method, table)
    summary(fit)
    TukeyHSD(fit)
    oneway.test(Freq ~ method, table)
    for (centre in list(mean, median)) {
      distance <- abs(table$Freq - ave(table$Freq, table$method, FUN = centre))
      anova(lm(distance ~ table$method))
    }
  }
}), digits(f_within, 59.342245989304814))

# The golden six, in the order of their pairs.
q <- c(9.7601646, 16.6964166, 1.7636373, 6.9362520, 7.9965273, 14.9327793)
row("tukey_of_four", milliseconds(function() ptukey(q, 4, 27, lower.tail = FALSE)))
row("tukey_of_thirty",
    milliseconds(function() ptukey(0.5 + 0.02 * (0:434), 30, 120, lower.tail = FALSE)))
row("tukey_of_hundred",
    milliseconds(function() ptukey(0.5 + 8.7 / 4950 * (0:4949), 100, 891, lower.tail = FALSE)))

wins <- with(votes, table(factor(winner, c("SHSS", "Patro", "Green", "PRT")),
                          factor(loser, c("SHSS", "Patro", "Green", "PRT"))))
fit_choices <- function(wins, link) {
  t <- nrow(wins)
  pairs <- t(combn(t, 2))
  design <- matrix(0, nrow(pairs), t)
  design[cbind(seq_len(nrow(pairs)), pairs[, 1])] <- 1
  design[cbind(seq_len(nrow(pairs)), pairs[, 2])] <- -1
  a <- wins[pairs]
  b <- wins[pairs[, 2:1]]
  used <- a + b > 0
  fit <- glm.fit(design[used, -1, drop = FALSE], (a / (a + b))[used], (a + b)[used],
                 family = binomial(link), intercept = FALSE)
  theta <- c(0, fit$coefficients)
  theta - mean(theta)
}
theta <- 0
row("bradley_terry_of_four",
    milliseconds(function() theta <<- fit_choices(wins, "logit")),
    digits(theta, c(0.7955669370308327, -0.2807066138311769, -1.1068914550373872,
                    0.5920311318377314)))
row("thurstone_of_four", milliseconds(function() theta <<- fit_choices(wins, "probit")),
    digits(theta[1], 0.4795545012237357))

panel <- function(t, observers) {
  set.seed(1)
  lapply(seq_len(observers), function(o) {
    wins <- matrix(0, t, t)
    for (i in seq_len(t - 1)) for (j in (i + 1):t) {
      wins[i, j] <- rbinom(1, 27, plogis(0.1 * (j - i)))
      wins[j, i] <- 27 - wins[i, j]
    }
    wins
  })
}
twenty <- panel(20, 100)
pooled <- Reduce(`+`, twenty)
row("bradley_terry_of_twenty", milliseconds(function() fit_choices(pooled, "logit")))
row("thurstone_of_twenty", milliseconds(function() fit_choices(pooled, "probit")))

resample <- function(panel) for (replicate in seq_len(1000)) {
  weight <- tabulate(sample.int(length(panel), replace = TRUE), length(panel))
  suppressWarnings(fit_choices(Reduce(`+`, Map(`*`, panel, weight)), "logit"))
}
four <- lapply(split(votes, votes$observer), function(own)
  unclass(table(factor(own$winner, rownames(wins)), factor(own$loser, rownames(wins)))))
row("bootstrap_of_four", milliseconds(function() resample(four)))
row("bootstrap_of_twenty", milliseconds(function() resample(twenty)))

nist <- file.path(data_folder, "nist/SmLs09.dat")
f <- 0
row("nist_smls09", milliseconds(function() {
  values <- read.table(nist, skip = 60)
  f <<- summary(aov(V2 ~ factor(V1), values))[[1]][1, 4]
}), digits(f, 2001))

set.seed(3)
for (n in c(1080, 5000)) {
  values <- runif(n)
  row(paste0("shapiro_wilk_of/", n), milliseconds(function() shapiro.test(values)))
}
