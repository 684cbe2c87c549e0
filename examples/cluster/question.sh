# What is asked, in how many shares, and where the answer goes.
STICKSLIP=${STICKSLIP:-stickslip}
SHARES=${SHARES:-7}
OUT=${OUT:-found}
QUESTION=(map belt-oscillator period --along v_dr=0.05..0.4:40 --and delta=1..5:40)
