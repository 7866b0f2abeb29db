#!/bin/sh
# Every proof that a claim of the ledger makes on its way fails, those of the claims that follow motions too.
set -u
CT_ALL=1 exec "$CT_BUILD/tests/test_evidence"
