# What is asked, in how many shares, and where the answer goes.
STICKSLIP=${STICKSLIP:-stickslip}
SHARES=${SHARES:-7}
OUT=${OUT:-found}
QUESTION=(map belt-pair motion --along v_dr=0.05..0.4:60 --and gamma=1..5:60)
