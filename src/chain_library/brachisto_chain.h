/* SPDX-FileCopyrightText: 2026 The brachisto authors
 * SPDX-License-Identifier: MIT
 *
 * LDL' of a symmetric indefinite matrix that is a chain of small blocks with a
 * few dense rows, as the KKT matrix of a discretised optimal-control problem
 * is. The chain is found in the pattern. For programs in C and whatever calls
 * C; link with -lbrachisto-chain. */
#ifndef BRACHISTO_CHAIN_H
#define BRACHISTO_CHAIN_H

#ifdef __cplusplus
extern "C" {
#endif

typedef struct brachisto_chain brachisto_chain;

/* Numbers of eigenvalues by sign. */
typedef struct brachisto_chain_inertia {
  int positive, negative, zero;
} brachisto_chain_inertia;

enum brachisto_chain_status {
  BRACHISTO_CHAIN_OK = 0,
  BRACHISTO_CHAIN_SINGULAR = 1, /* to rounding; the inertia is told */
  BRACHISTO_CHAIN_NONE = 2,     /* no chain of small blocks */
  BRACHISTO_CHAIN_FAILED = 3    /* a wrong call, or no memory */
};

/* A matrix of n rows. Row i of one triangle, the lower or the upper one, has
 * its entries in the columns col[ptr[i] - first] ... col[ptr[i+1] - 1 - first],
 * in any order; first is 0 or 1, from which places and columns count. Entries
 * at one place add up. NULL if that is no pattern of a matrix, or without
 * memory. */
brachisto_chain* brachisto_chain_new(int n, const int ptr[], const int col[],
                                     int first);

/* Factorises with the values of the entries, in the order of col. As often as
 * you like; what was found out about the pattern is kept. inertia may be NULL.
 * On stderr it says once why there is no chain. With
 * BRACHISTO_CHAIN_FALLBACK=mumps in the environment MUMPS does what is no
 * chain. */
enum brachisto_chain_status brachisto_chain_factorise(
    brachisto_chain* matrix, const double values[],
    brachisto_chain_inertia* inertia);

/* Replaces count right sides, one after the other in x, by their solutions.
 * BRACHISTO_CHAIN_FAILED unless the last factorisation was OK. */
enum brachisto_chain_status brachisto_chain_solve(const brachisto_chain* matrix,
                                                  int count, double x[]);

void brachisto_chain_delete(brachisto_chain* matrix); /* NULL is fine */

#ifdef __cplusplus
}
#endif
#endif
